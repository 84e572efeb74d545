// SPDX-License-Identifier: MIT
#include "benchmark/training/supervised/color_jitter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "sim/base/error.h"
#include "sim/sensors/noise/picture_noise.h"

namespace bulletnav::bench {
namespace {

constexpr double kMiddleGrey = 127.5;
constexpr double kPanes = 0.5;  // in a picture at strength 1

using Table = std::array<std::uint8_t, 256>;

double Factor(double spread, sim::Rng* rng) {
  return rng->Uniform(1.0 - spread, 1.0 + spread);
}

}  // namespace

void ColorJitter::Validate() const {
  for (const double spread : {brightness, contrast, tint}) {
    if (!(spread >= 0.0 && spread < 1.0)) {
      throw sim::Error("brightness, contrast and tint must be in [0, 1)");
    }
  }
}

void Recolor(const ColorJitter& jitter, sim::Rng* rng, std::span<std::uint8_t> color) {
  if (jitter.is_none()) return;
  const double brightness = Factor(jitter.brightness, rng);
  const double contrast = Factor(jitter.contrast, rng);
  std::array<Table, 3> tables{};
  for (Table& table : tables) {
    const double gain = brightness * Factor(jitter.tint, rng);
    for (std::size_t v = 0; v < table.size(); ++v) {
      const double value = (static_cast<double>(v) * gain - kMiddleGrey) * contrast + kMiddleGrey;
      table[v] = static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0)));
    }
  }
  for (std::size_t i = 0; i < color.size(); i += 3) {
    for (std::size_t c = 0; c < 3; ++c) color[i + c] = tables[c][color[i + c]];
  }
}

namespace {

sim::SensorNoise DrawSensorNoise(double strength, sim::Rng* rng) {
  std::vector<std::string> names = sim::SensorNoiseNames();
  names.erase(names.begin());
  sim::SensorNoise noise = sim::NamedSensorNoise(rng->Pick(names));
  if (noise.depth != sim::DepthNoise()) noise.depth.panes = kPanes;
  return sim::Scaled(noise, rng->Uniform(0.0, strength));
}

}  // namespace

void AddSensorNoise(double share, double strength, const sim::CameraSpec& camera, sim::Rng rng,
                    std::span<std::uint8_t> color, std::span<float> depth) {
  if (!rng.Chance(share)) return;
  const sim::SensorNoise noise = DrawSensorNoise(strength, &rng);
  sim::PictureNoise(noise, camera).Apply(rng.Fork("picture"), color, depth);
}

void RequireSensorNoise(double share, double strength) {
  if (!(share >= 0.0 && share <= 1.0)) {
    throw sim::KeyError("sensor_noise", "is a share, 0 to 1");
  }
  if (!(strength > 0.0 && strength <= 4.0)) {
    throw sim::KeyError("noise_strength", "must be above 0 and at most 4");
  }
}

}  // namespace bulletnav::bench
