// SPDX-License-Identifier: MIT
#include "benchmark/training/supervised/augment.h"

#include <span>

#include "agent/models/semantic_model.h"
#include "agent/perception/model_config.h"
#include "sim/base/error.h"
#include "sim/sensors/noise/picture_noise.h"

namespace bulletnav::bench {
namespace {

constexpr double kNoiseStrength = 1.5;

/// The camera that all batches are from, as far as noise asks.
sim::PanoramaSpec Camera() {
  sim::PanoramaSpec camera;
  camera.rows = agent::kPanoramaRows;
  camera.cols = agent::kPanoramaCols;
  return camera;
}

void AddSensorNoise(const AugmentSpec& spec, sim::Rng rng, std::span<std::uint8_t> color,
                    std::span<float> depth) {
  if (!rng.Chance(spec.sensor_noise.value_or(0.0))) return;
  const sim::SensorNoise noise =
      DrawSensorNoise(spec.noise_strength.value_or(kNoiseStrength), &rng);
  sim::PictureNoise(noise, Camera()).Apply(rng.Fork("picture"), color, depth);
}

}  // namespace

void AugmentSpec::Validate() const {
  color().Validate();
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
  const bool has_depth = depth == DepthUse::kInput && !batch->depth.empty();
  const sim::Rng noise = rng.Fork("sensor_noise");
  for (int i = 0; i < batch->count; ++i) {
    const auto first = static_cast<std::size_t>(i) * pixels;
    const std::span<std::uint8_t> color = std::span(batch->color).subspan(3 * first, 3 * pixels);
    if (spec.turn) TurnPanorama(i, rng.Below(agent::kDirections), batch);
    Recolor(spec.color(), &rng, color);
    if (!spec.sensor_noise) continue;
    const std::span<float> seen =
        has_depth ? std::span(batch->depth).subspan(first, pixels) : std::span<float>();
    AddSensorNoise(spec, noise.Fork("panorama", static_cast<std::uint64_t>(i)), color, seen);
  }
}

}  // namespace bulletnav::bench
