// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "sim/sensors/sensor.h"

namespace bulletnav::sim {

/// What a camera writes: `color` u8 [rows, cols, 3] RGB, `depth` f32 [rows, cols] metres along the
/// ray, `semantic` i32 [rows, cols] numbers in SceneMesh::objects; see Renderer. Nobody pays for a
/// channel that is not asked for.
struct CameraChannels {
  /// Throws KeyError unless all of them are known, each at most once, and there is one at least.
  static void Validate(const std::vector<std::string>& channels);
  static std::vector<ArraySpec> Arrays(const CameraSpec& camera,
                                       const std::vector<std::string>& channels);
};

/// A panorama from the body's camera height.
struct PanoramaSensorConfig {
  PanoramaSpec panorama;
  std::vector<std::string> channels = {"color", "depth"};

  template <class V>
  void Visit(V& v) {
    panorama.Visit(v);
    v("channels", channels);
  }
  void Validate() const {
    panorama.Validate();
    CameraChannels::Validate(channels);
  }
};

/// Where a camera sits on the body, level except for its own pitch.
struct CameraMount {
  double forward_m = 0.0;  // of the body's axis
  double left_m = 0.0;
  double above_m = 0.0;  // over the body's camera height; negative: under it
  double yaw_deg = 0.0;  // positive looks to the left

  template <class V>
  void Visit(V& v) {
    v("forward_m", forward_m);
    v("left_m", left_m);
    v("above_m", above_m);
    v("yaw_deg", yaw_deg);
  }
  /// Throws Error for numbers that are not finite.
  void Validate() const;
  /// The camera's pose when the body is at `pose` and its own camera at `eye`.
  CameraPose On(const BodyPose& pose, const CameraPose& eye) const;
};

/// A flat picture.
struct PinholeSensorConfig {
  PinholeSpec camera;
  CameraMount mount;
  std::vector<std::string> channels = {"color", "depth"};

  template <class V>
  void Visit(V& v) {
    camera.Visit(v);
    v("mount", mount);
    v("channels", channels);
  }
  void Validate() const {
    camera.Validate();
    mount.Validate();
    CameraChannels::Validate(channels);
  }
};

/// These two types, for sets made in C++. Throw Error for bad settings.
ConfiguredSensor PanoramaSensor(const PanoramaSensorConfig& config);
ConfiguredSensor PinholeSensor(const PinholeSensorConfig& config);

/// Draws the channels of a camera in a scene.
class CameraReader {
 public:
  /// Throws Error if `semantic` is asked for in a scene whose objects are not known, RenderError if
  /// the scene's backend cannot tell them.
  CameraReader(const RenderScene& scene, const CameraSpec& camera,
               const std::vector<std::string>& channels);

  /// `out`: as Sensor::Read gets it; `glass`: SensorInput's.
  void Read(const CameraPose& pose, std::span<const std::span<std::byte>> out,
            std::span<std::uint8_t> glass);

 private:
  std::unique_ptr<Renderer> renderer_;
  std::vector<std::string> channels_;
};

}  // namespace bulletnav::sim
