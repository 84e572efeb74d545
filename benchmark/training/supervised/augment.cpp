// SPDX-License-Identifier: MIT
#include "benchmark/training/supervised/augment.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "agent/models/semantic_model.h"
#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

constexpr double kMiddleGrey = 127.5;

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

}  // namespace

void AugmentSpec::Validate() const {
  for (const double spread : {brightness, contrast, tint}) {
    if (!(spread >= 0.0 && spread < 1.0)) {
      throw sim::Error("brightness, contrast and tint must be in [0, 1)");
    }
  }
}

void Augment(const AugmentSpec& spec, sim::Rng rng, PairBatch* batch) {
  const std::size_t size = batch->color.size() / static_cast<std::size_t>(batch->count);
  const bool recolors = spec.brightness > 0.0 || spec.contrast > 0.0 || spec.tint > 0.0;
  for (int i = 0; i < batch->count; ++i) {
    if (spec.turn) TurnPanorama(i, rng.Below(agent::kDirections), batch);
    if (recolors) {
      Recolor(spec, &rng,
              std::span(batch->color).subspan(static_cast<std::size_t>(i) * size, size));
    }
  }
}

}  // namespace bulletnav::bench
