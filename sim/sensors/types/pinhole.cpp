// SPDX-License-Identifier: MIT
#include "sim/sensors/cameras.h"

namespace bulletnav::sim {
namespace {

/// A flat picture of what is in front of a camera somewhere on the body.
class Pinhole final : public Sensor {
 public:
  static constexpr std::string_view kName = "pinhole";
  using Config = PinholeSensorConfig;

  static CameraSpec Camera(const Config& config) { return config.camera; }
  static std::vector<ArraySpec> Arrays(const Config& config) {
    return CameraChannels::Arrays(config.camera, config.channels);
  }

  Pinhole(const Config& config, const SensorScene& scene)
      : mount_(config.mount), camera_(scene.render, config.camera, config.channels) {}

  void Read(const SensorInput& input, std::span<const std::span<std::byte>> out) override {
    camera_.Read(mount_.On(input.pose, input.eye), out, input.glass);
  }

 private:
  CameraMount mount_;
  CameraReader camera_;
};

const SensorRegistration<Pinhole> registration;

}  // namespace

ConfiguredSensor PinholeSensor(const PinholeSensorConfig& config) {
  return Configure<Pinhole>(config);
}

}  // namespace bulletnav::sim
