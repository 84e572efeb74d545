// SPDX-License-Identifier: MIT
#include "sim/sensors/noise/sensor_noise.h"

#include <algorithm>
#include <map>

#include "sim/base/check.h"
#include "sim/base/error.h"
#include "sim/config/yaml_reader.h"
#include "sim/sensors/noise/builtin_sensor_noise.h"

namespace bulletnav::sim {
namespace {

constexpr const char* kNone = "none";
constexpr double kMaxBlur = 0.8;    // of what three pixels in a row can spread
constexpr double kMostDepth = 1e6;  // of all numbers of a depth noise
constexpr double kMostElectrons = 1e9;

struct ModelsConfig {
  std::string schema;
  std::map<std::string, SensorNoise> models;

  template <class V>
  void Visit(V& v) {
    v.Required("schema", schema);
    v.Required("models", models);
  }
  void Validate() const {
    if (schema != "bulletnav_sensor_noise/1") {
      throw Error("schema must be bulletnav_sensor_noise/1");
    }
  }
};

const std::map<std::string, SensorNoise>& Models() {
  static const auto config =
      LoadYamlText<ModelsConfig>(kBuiltinSensorNoiseYaml, "built-in sensor_noise.yaml");
  return config.models;
}

}  // namespace

void DepthNoise::Validate() const {
  for (const double value :
       {axial_m, axial_per_m2, axial_from_m, grazing_m, disparity_m, lateral_rad, baseline_m,
        min_range_m, max_range_m, min_signal, panes}) {
    if (!(value >= 0.0 && value <= kMostDepth)) {
      throw Error("depth noise is numbers from 0 to a million");
    }
  }
  if (!(max_angle_deg > 0.0 && max_angle_deg <= 90.0)) {
    throw KeyError("max_angle_deg", "must be above 0 and at most 90");
  }
  for (const double share : {glass_lost, glass_behind}) {
    if (!(share >= 0.0 && share <= 1.0)) {
      throw Error("glass_lost and glass_behind are shares, from 0 to 1");
    }
  }
  if (!(lateral_rad <= 0.1 && baseline_m <= 1.0)) {
    throw Error("lateral_rad is at most 0.1, baseline_m at most 1");
  }
}

void ColorNoise::Validate() const {
  if (!(exposure_stops >= 0.0 && exposure_stops <= 4.0)) {
    throw KeyError("exposure_stops", "must be from 0 to 4");
  }
  if (!(white_balance >= 0.0 && white_balance < 1.0)) {
    throw KeyError("white_balance", "must be in [0, 1)");
  }
  if (!(blur_px >= 0.0 && blur_px <= kMaxBlur)) {
    throw KeyError("blur_px", "must be from 0 to 0.8");
  }
  if (!(electrons >= 0.0 && electrons <= kMostElectrons && read_electrons >= 0.0 &&
        read_electrons <= 1e6)) {
    throw Error("electrons are from 0 to a billion, read_electrons from 0 to a million");
  }
}

std::vector<std::string> SensorNoiseNames() {
  std::vector<std::string> names = {kNone};
  for (const auto& [name, noise] : Models()) names.push_back(name);
  return names;
}

SensorNoise NamedSensorNoise(std::string_view name) {
  if (name == kNone) return {};
  const auto found = Models().find(std::string(name));
  if (found != Models().end()) return found->second;
  std::string known;
  for (const std::string& one : SensorNoiseNames()) known += (known.empty() ? "" : ", ") + one;
  throw Error("unknown sensor noise '" + std::string(name) + "'; known are: " + known);
}

void RequireSensorNoise(std::string_view name) {
  try {
    NamedSensorNoise(name);
  } catch (const Error& e) {
    throw KeyError("sensor_noise", e.what());
  }
}

SensorNoise Scaled(const SensorNoise& noise, double strength) {
  BULLETNAV_CHECK(strength >= 0.0 && strength <= 4.0);
  if (strength == 0.0) return {};
  SensorNoise scaled = noise;
  DepthNoise& depth = scaled.depth;
  for (double* value : {&depth.axial_m, &depth.axial_per_m2, &depth.grazing_m, &depth.baseline_m,
                        &depth.lateral_rad, &depth.min_signal, &depth.panes}) {
    *value *= strength;
  }
  depth.glass_lost = std::min(1.0, depth.glass_lost * strength);
  depth.disparity_m = std::min(kMostDepth, depth.disparity_m / strength);
  ColorNoise& color = scaled.color;
  color.exposure_stops *= strength;
  color.white_balance = std::min(0.9, color.white_balance * strength);
  color.blur_px = std::min(kMaxBlur, color.blur_px * strength);
  color.electrons = std::min(kMostElectrons, color.electrons / (strength * strength));
  return scaled;
}

}  // namespace bulletnav::sim
