// SPDX-License-Identifier: MIT
#include "benchmark/training/supervised/augment.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "agent/models/semantic_model.h"
#include "agent/perception/model_config.h"
#include "sim/base/error.h"
#include "sim/sensors/noise/picture_noise.h"

namespace bulletnav::bench {
namespace {

constexpr double kMiddleGrey = 127.5;
constexpr double kNoiseStrength = 1.5;
constexpr double kPanes = 0.5;  // in a panorama at strength 1

using Table = std::array<std::uint8_t, 256>;

double Factor(double spread, sim::Rng* rng) {
  return rng->Uniform(1.0 - spread, 1.0 + spread);
}

void Recolor(const AugmentSpec& spec, sim::Rng* rng, std::span<std::uint8_t> color) {
  const double brightness = Factor(spec.brightness, rng);
  const double contrast = Factor(spec.contrast, rng);
  std::array<Table, 3> tables{};
  for (Table& table : tables) {
    const double gain = brightness * Factor(spec.tint, rng);
    for (std::size_t v = 0; v < table.size(); ++v) {
      const double value = (static_cast<double>(v) * gain - kMiddleGrey) * contrast + kMiddleGrey;
      table[v] = static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0)));
    }
  }
  for (std::size_t i = 0; i < color.size(); i += 3) {
    for (std::size_t c = 0; c < 3; ++c) color[i + c] = tables[c][color[i + c]];
  }
}

/// The camera that all batches are from, as far as noise asks.
sim::PanoramaSpec Camera() {
  sim::PanoramaSpec camera;
  camera.rows = agent::kPanoramaRows;
  camera.cols = agent::kPanoramaCols;
  return camera;
}

/// A named model other than none.
sim::SensorNoise DrawNoise(double strength, sim::Rng* rng) {
  std::vector<std::string> names = sim::SensorNoiseNames();
  names.erase(names.begin());
  sim::SensorNoise noise = sim::NamedSensorNoise(rng->Pick(names));
  if (noise.depth != sim::DepthNoise()) noise.depth.panes = kPanes;
  return sim::Scaled(noise, rng->Uniform(0.0, strength));
}

void AddSensorNoise(const AugmentSpec& spec, sim::Rng rng, std::span<std::uint8_t> color,
                    std::span<float> depth) {
  if (!rng.Chance(spec.sensor_noise.value_or(0.0))) return;
  const sim::SensorNoise noise = DrawNoise(spec.noise_strength.value_or(kNoiseStrength), &rng);
  sim::PictureNoise(noise, Camera()).Apply(rng.Fork("picture"), color, depth);
}

}  // namespace

void AugmentSpec::Validate() const {
  for (const double spread : {brightness, contrast, tint}) {
    if (!(spread >= 0.0 && spread < 1.0)) {
      throw sim::Error("brightness, contrast and tint must be in [0, 1)");
    }
  }
  const double share = sensor_noise.value_or(0.0);
  if (!(share >= 0.0 && share <= 1.0)) {
    throw sim::KeyError("sensor_noise", "is a share, 0 to 1");
  }
  const double strength = noise_strength.value_or(kNoiseStrength);
  if (!(strength > 0.0 && strength <= 4.0)) {
    throw sim::KeyError("noise_strength", "must be above 0 and at most 4");
  }
}

void Augment(const AugmentSpec& spec, sim::Rng rng, DepthUse depth, PairBatch* batch) {
  const std::size_t pixels = batch->color.size() / static_cast<std::size_t>(batch->count) / 3;
  const bool recolors = spec.brightness > 0.0 || spec.contrast > 0.0 || spec.tint > 0.0;
  const bool has_depth = depth == DepthUse::kInput && !batch->depth.empty();
  const sim::Rng noise = rng.Fork("sensor_noise");
  for (int i = 0; i < batch->count; ++i) {
    const auto first = static_cast<std::size_t>(i) * pixels;
    const std::span<std::uint8_t> color = std::span(batch->color).subspan(3 * first, 3 * pixels);
    if (spec.turn) TurnPanorama(i, rng.Below(agent::kDirections), batch);
    if (recolors) Recolor(spec, &rng, color);
    if (!spec.sensor_noise) continue;
    const std::span<float> seen =
        has_depth ? std::span(batch->depth).subspan(first, pixels) : std::span<float>();
    AddSensorNoise(spec, noise.Fork("panorama", static_cast<std::uint64_t>(i)), color, seen);
  }
}

}  // namespace bulletnav::bench
