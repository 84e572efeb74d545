// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sim/config/yaml_reader.h"
#include "sim/config/yaml_writer.h"
#include "sim/math/rng.h"
#include "sim/navmesh/navmesh.h"
#include "sim/observation.h"
#include "sim/physics/physics_world.h"
#include "sim/render/renderer.h"
#include "sim/sensors/array.h"

namespace bulletnav::sim {

/// The scene that a sensor is in; it outlives the sensor.
struct SensorScene {
  const RenderScene& render;
  const PhysicsWorld& physics;
  const Navmesh& navmesh;
};

/// The body that reads, after a reset or a step. Sensors are parts of the simulator: they know the
/// truth, and an agent gets only what they write.
struct SensorInput {
  BodyPose pose;                 // where the body really is
  CameraPose eye;                // at its camera's height
  Sensors step;                  // what the last step measured; zero after a reset
  RngKey key;                    // of the sensors' random numbers in this step
  std::string_view sensor = {};  // its name on the body
  /// Where a camera writes which of its pixels show glass, u8 [rows, cols], as
  /// PictureMemory::glass; empty: not wanted. One that does not write has none.
  std::span<std::uint8_t> glass = {};

  /// For noise: other numbers for each sensor, episode and step.
  Rng noise() const { return Rng(key).Fork(sensor); }
};

/// A sensor of a body, made for a scene. What it writes is a function of the input alone, since
/// bodies share it, one after the other.
class Sensor {
 public:
  virtual ~Sensor() = default;
  Sensor(const Sensor&) = delete;
  Sensor& operator=(const Sensor&) = delete;
  Sensor(Sensor&&) = delete;
  Sensor& operator=(Sensor&&) = delete;

  /// Writes its arrays, in the order of its type's Arrays, each into memory of its size; an empty
  /// span: not wanted.
  virtual void Read(const SensorInput& input, std::span<const std::span<std::byte>> out) = 0;

 protected:
  Sensor() = default;
};

/// The values of an array to be written.
template <class T>
std::span<T> ValuesIn(std::span<std::byte> bytes) {
  return {reinterpret_cast<T*>(bytes.data()), bytes.size() / sizeof(T)};
}

/// A type of sensor with its settings.
struct ConfiguredSensor {
  std::string type;
  std::string yaml;                  // its block, every default spelled out
  std::vector<ArraySpec> arrays;     // named by channel: "depth"
  std::optional<CameraSpec> camera;  // what it draws, if it is a camera
  std::function<std::unique_ptr<Sensor>(const SensorScene&)> make;
};

/// Names of all registered types, in alphabetical order.
std::vector<std::string> SensorTypes();

/// A block `{type: pinhole, hfov_deg: 79}`, or the name of a type alone. Throws FileError at the
/// place of what is wrong.
ConfiguredSensor ConfigureSensor(const YamlNode& block);
/// A type as it is by default. Throws Error for an unknown one, with the known ones.
ConfiguredSensor ConfigureSensor(std::string_view type);

namespace internal {

using SensorConfigurer = std::function<ConfiguredSensor(const std::optional<YamlNode>&)>;

/// Throws Error if the name is taken.
void RegisterSensor(std::string_view type, const SensorConfigurer& configure);

/// The settings of a type, with the key that names it.
template <class Config>
struct TypedConfig {
  std::string type;
  Config config = {};

  template <class V>
  void Visit(V& v) {
    v.Required("type", type);
    config.Visit(v);
  }
  void Validate() const {
    if constexpr (requires { config.Validate(); }) config.Validate();
  }
};

}  // namespace internal

/// Sensor type S with its settings. Throws Error for bad ones.
template <class S>
ConfiguredSensor Configure(const typename S::Config& config) {
  const internal::TypedConfig<typename S::Config> typed{std::string(S::kName), config};
  typed.Validate();
  ConfiguredSensor sensor;
  sensor.type = typed.type;
  sensor.yaml = ToYaml(typed);
  sensor.arrays = S::Arrays(config);
  if constexpr (requires { S::Camera(config); }) sensor.camera = S::Camera(config);
  sensor.make = [config](const SensorScene& scene) {
    return std::make_unique<S>(config, scene);
  };
  return sensor;
}

/// Makes sensor type S known by its name. One constant of this type at the end of S's file does it.
template <class S>
class SensorRegistration {
 public:
  SensorRegistration() {
    internal::RegisterSensor(S::kName, [](const std::optional<YamlNode>& block) {
      internal::TypedConfig<typename S::Config> typed;
      if (block) YamlReader::Read(*block, typed);
      return Configure<S>(typed.config);
    });
  }
};

}  // namespace bulletnav::sim
