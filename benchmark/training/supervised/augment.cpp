// SPDX-License-Identifier: MIT
#include "benchmark/training/supervised/augment.h"

#include <span>

#include "agent/models/semantic_model.h"
#include "agent/perception/model_config.h"

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

}  // namespace

void AugmentSpec::Validate() const {
  color().Validate();
  RequireSensorNoise(sensor_noise.value_or(0.0), noise_strength.value_or(kNoiseStrength));
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
    AddSensorNoise(*spec.sensor_noise, spec.noise_strength.value_or(kNoiseStrength), Camera(),
                   noise.Fork("panorama", static_cast<std::uint64_t>(i)), color, seen);
  }
}

}  // namespace bulletnav::bench
