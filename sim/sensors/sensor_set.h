// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/sensors/sensor.h"

namespace bulletnav::sim {

/// A sensor of a body by the name it has there.
struct MountedSensor {
  std::string name;
  ConfiguredSensor sensor;
};

/// The sensors of a body. Its arrays are called "sensor.channel", as in "front.depth".
class SensorSet {
 public:
  SensorSet() = default;

  /// A sensor `panorama` with these channels, if any, and `odometry` and `bumper`. Throws Error for
  /// a bad spec.
  static SensorSet Usual(const PanoramaSpec& panorama, bool color, bool depth);
  /// A set by name: `rgb` (panorama of colour, odometry, bumper) or `rgbd` (with depth). Throws
  /// Error for other names.
  static SensorSet Named(std::string_view name);
  /// From YAML: the name of a set, or a map of sensors:
  ///   panorama: {type: panorama, rows: 64, cols: 256, channels: [depth]}
  ///   front: {type: pinhole, hfov_deg: 79, pitch_deg: -15}
  ///   bumper: bumper
  /// Throws FileError at the place of what is wrong.
  static SensorSet Read(const YamlNode& node);

  /// Throws Error if the name is taken, or is not made of lower-case letters, digits and
  /// underscores.
  void Add(const std::string& name, const ConfiguredSensor& sensor);

  bool empty() const { return sensors_.empty(); }
  const std::vector<MountedSensor>& sensors() const { return sensors_; }
  /// Null if there is none of this name.
  const ConfiguredSensor* Find(std::string_view name) const;
  /// What the sensor `panorama` draws, if it is there and of that type.
  std::optional<PanoramaSpec> panorama() const;
  /// Of all sensors, in their order, by their full names.
  std::vector<ArraySpec> arrays() const;
  /// As Read takes it, every default spelled out.
  std::string ToYaml() const;

 private:
  std::vector<MountedSensor> sensors_;
};

/// For YamlReader.
inline void ReadYaml(const YamlNode& node, SensorSet& value) {
  value = SensorSet::Read(node);
}

}  // namespace bulletnav::sim
