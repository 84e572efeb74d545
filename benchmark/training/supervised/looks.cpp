// SPDX-License-Identifier: MIT
#include "benchmark/training/supervised/looks.h"

#include <array>

#include "sim/base/error.h"
#include "sim/math/rng.h"

namespace bulletnav::bench {
namespace {

constexpr std::array kShrinks = {4, 16, 64};

double Factor(double less, double more, sim::Rng* rng) {
  return rng->Uniform(1.0 - less, 1.0 + more);
}

}  // namespace

void LooksSpec::Validate() const {
  for (const double value : {share, no_ceiling, blank_floor, flat, vertex_colors, unlit, shrunk,
                             exposure, contrast, saturation, tint}) {
    if (!(value >= 0.0 && value <= 1.0)) throw sim::Error("looks are shares and spreads, 0 to 1");
  }
  if (!(flat + vertex_colors <= 1.0)) {
    throw sim::Error("flat and vertex_colors exclude each other: at most 1 together");
  }
}

sim::Finish DrawLook(const LooksSpec& spec, std::uint64_t seed, const std::string& scene) {
  sim::Rng rng = sim::Rng(seed, "looks").Fork(scene);
  sim::Finish finish;
  if (!rng.Chance(spec.share)) return finish;
  finish.ceiling = !rng.Chance(spec.no_ceiling);
  finish.blank_floor = rng.Chance(spec.blank_floor);
  const double surfaces = rng.Uniform();
  if (surfaces < spec.flat) {
    finish.surfaces = sim::Surfaces::kFlat;
  } else if (surfaces < spec.flat + spec.vertex_colors) {
    finish.surfaces = sim::Surfaces::kVertexColors;
  }
  // Without light and colours there would be nothing to see at all.
  const bool is_lit = finish.surfaces == sim::Surfaces::kVertexColors || !rng.Chance(spec.unlit);
  finish.baked_light = is_lit;
  if (rng.Chance(spec.shrunk)) finish.texture_shrink = rng.Pick(kShrinks);
  finish.exposure = Factor(spec.exposure, spec.exposure, &rng);
  finish.contrast = Factor(spec.contrast, spec.contrast, &rng);
  finish.saturation = Factor(spec.saturation, spec.saturation / 2, &rng);
  for (double& tint : finish.tint) tint = Factor(spec.tint, spec.tint, &rng);
  return finish;
}

}  // namespace bulletnav::bench
