// SPDX-License-Identifier: MIT
#include "sim/sensors/sensor_set.h"

#include <algorithm>
#include <sstream>

#include "sim/sensors/cameras.h"

namespace bulletnav::sim {
namespace {

bool IsName(const std::string& text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
  });
}

}  // namespace

SensorSet SensorSet::Usual(const PanoramaSpec& panorama, bool color, bool depth) {
  SensorSet set;
  PanoramaSensorConfig config{panorama, {}};
  if (color) config.channels.emplace_back("color");
  if (depth) config.channels.emplace_back("depth");
  if (!config.channels.empty()) set.Add("panorama", PanoramaSensor(config));
  for (const char* type : {"odometry", "bumper"}) set.Add(type, ConfigureSensor(type));
  return set;
}

SensorSet SensorSet::Named(std::string_view name) {
  if (name == "rgb") return Usual({}, true, false);
  if (name == "rgbd") return Usual({}, true, true);
  throw Error("unknown set of sensors '" + std::string(name) + "'; known are: rgb, rgbd");
}

SensorSet SensorSet::Read(const YamlNode& node) {
  if (node.yaml().IsScalar()) {
    try {
      return Named(node.ToString());
    } catch (const Error& e) {
      node.Fail(e.what());
    }
  }
  node.ExpectMap();
  SensorSet set;
  for (const auto& item : node.yaml()) {
    const YamlNode name = node.Child(item.first);
    const ConfiguredSensor sensor = ConfigureSensor(node.Child(item.second));
    try {
      set.Add(name.ToString(), sensor);
    } catch (const Error& e) {
      name.Fail(e.what());
    }
  }
  return set;
}

void SensorSet::Add(const std::string& name, const ConfiguredSensor& sensor) {
  if (!IsName(name)) {
    throw Error("'" + name + "' is no name for a sensor: lower-case letters, digits and _ alone");
  }
  if (Find(name) != nullptr) throw Error("two sensors are called '" + name + "'");
  sensors_.push_back({name, sensor});
}

const ConfiguredSensor* SensorSet::Find(std::string_view name) const {
  for (const MountedSensor& mounted : sensors_) {
    if (mounted.name == name) return &mounted.sensor;
  }
  return nullptr;
}

std::optional<PanoramaSpec> SensorSet::panorama() const {
  const ConfiguredSensor* sensor = Find("panorama");
  if (sensor == nullptr || !sensor->camera) return std::nullopt;
  const PanoramaSpec* spec = std::get_if<PanoramaSpec>(&*sensor->camera);
  return spec == nullptr ? std::nullopt : std::optional(*spec);
}

std::vector<ArraySpec> SensorSet::arrays() const {
  std::vector<ArraySpec> all;
  for (const MountedSensor& mounted : sensors_) {
    for (const ArraySpec& array : mounted.sensor.arrays) {
      all.push_back(array);
      all.back().name = mounted.name + "." + array.name;
    }
  }
  return all;
}

std::string SensorSet::ToYaml() const {
  std::string text;
  for (const MountedSensor& mounted : sensors_) {
    text += mounted.name + ":\n";
    std::istringstream lines(mounted.sensor.yaml);
    for (std::string line; std::getline(lines, line);) text += "  " + line + "\n";
  }
  return text;
}

}  // namespace bulletnav::sim
