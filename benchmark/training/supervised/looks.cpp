// SPDX-License-Identifier: MIT
#include "benchmark/training/supervised/looks.h"

#include <algorithm>
#include <array>

#include "sim/base/elementary.h"
#include "sim/base/error.h"
#include "sim/math/rng.h"

namespace bulletnav::bench {
namespace {

constexpr std::array kShrinks = {4, 16, 64};
constexpr double kSteepest = 0.1;  // height of bumps over their size

/// Between positive numbers, as often below their geometric mean as above it.
double DrawScale(double low, double high, sim::Rng* rng) {
  return low * sim::Pow(high / low, rng->Uniform());
}

sim::Bumps DrawBumps(sim::Rng rng) {
  sim::Bumps bumps;
  bumps.height = DrawScale(0.005, 0.05, &rng);
  bumps.size = DrawScale(0.15, 1.0, &rng);
  // Steeper would be rubble.
  bumps.height = std::min(bumps.height, kSteepest * bumps.size);
  return bumps;
}

sim::Doubled DrawDoubled(sim::Rng rng) {
  sim::Doubled doubled;
  doubled.share = rng.Uniform(0.02, 0.25);
  doubled.offset = rng.Uniform(0.02, 0.08);
  return doubled;
}

sim::Holes DrawHoles(sim::Rng rng) {
  sim::Holes holes;
  holes.share = DrawScale(0.01, 0.15, &rng);
  holes.size = DrawScale(0.15, 1.5, &rng);
  holes.floors = rng.Chance(0.5);
  return holes;
}

sim::Smears DrawSmears(sim::Rng rng) {
  sim::Smears smears;
  smears.share = rng.Uniform(0.1, 0.6);
  smears.length = DrawScale(0.02, 0.3, &rng);
  return smears;
}

/// Draws of their own, so that other kinds of damage change nothing of a look.
sim::Damage DrawDamage(const LooksSpec& spec, const sim::Rng& look) {
  sim::Rng rng = look.Fork("damage");
  sim::Damage damage;
  const std::uint32_t seed = rng.Next();
  const auto low_poly = rng.Uniform(0.06, 0.25);
  if (rng.Chance(spec.low_poly)) damage.low_poly = low_poly;
  const auto spacing = rng.Uniform(0.06, 0.2);
  if (rng.Chance(spec.color_spacing)) damage.color_spacing = spacing;
  const auto clutter = rng.Uniform(1.0, 8.0);
  if (rng.Chance(spec.clutter)) damage.clutter = clutter;
  if (rng.Chance(spec.bumps)) damage.bumps = DrawBumps(rng.Fork("bumps"));
  if (rng.Chance(spec.doubled)) damage.doubled = DrawDoubled(rng.Fork("doubled"));
  if (rng.Chance(spec.holes)) damage.holes = DrawHoles(rng.Fork("holes"));
  if (rng.Chance(spec.smears)) damage.smears = DrawSmears(rng.Fork("smears"));
  const auto mirrored = rng.Uniform(0.05, 0.5);
  if (rng.Chance(spec.mirrored)) damage.mirrored = mirrored;
  if (damage != sim::Damage{}) damage.seed = seed;
  return damage;
}

/// Draws of its own, too.
sim::Repaint DrawRepaint(const LooksSpec& spec, sim::Rng rng) {
  sim::Repaint repaint;
  const std::uint32_t seed = rng.Next();
  const auto recolored = rng.Uniform(0.3, 1.0);
  if (rng.Chance(spec.recolored)) repaint.recolored = recolored;
  const auto exchanged = rng.Uniform(0.2, 0.8);
  if (rng.Chance(spec.exchanged)) repaint.exchanged = exchanged;
  if (repaint != sim::Repaint{}) repaint.seed = seed;
  return repaint;
}

/// White scenes as others make them: with a grey floor or all white, which is nothing to see
/// without light.
void Whiten(sim::Rng rng, sim::Finish* finish) {
  finish->blank_floor = rng.Chance(0.5);
  finish->baked_light = !(finish->blank_floor && rng.Chance(0.5));
}

double Factor(double less, double more, sim::Rng* rng) {
  return rng->Uniform(1.0 - less, 1.0 + more);
}

}  // namespace

void LooksSpec::Validate() const {
  for (const double value :
       {share,       no_ceiling,     blank_floor, flat,          vertex_colors, unlit,
        shrunk,      exposure,       contrast,    saturation,    tint,          white,
        blank_walls, black_overhead, low_poly,    color_spacing, clutter,       bumps,
        doubled,     holes,          smears,      mirrored,      recolored,     exchanged}) {
    if (!(value >= 0.0 && value <= 1.0)) throw sim::Error("looks are shares and spreads, 0 to 1");
  }
  if (!(flat + vertex_colors + white <= 1.0)) {
    throw sim::Error("flat, vertex_colors and white exclude each other: at most 1 together");
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
  } else if (surfaces < spec.flat + spec.vertex_colors + spec.white) {
    finish.surfaces = sim::Surfaces::kAllWhite;
  }
  // Without light and colours there would be nothing to see at all.
  const bool is_bare = finish.surfaces == sim::Surfaces::kVertexColors ||
                       finish.surfaces == sim::Surfaces::kAllWhite;
  const bool is_lit = is_bare || !rng.Chance(spec.unlit);
  finish.baked_light = is_lit;
  if (rng.Chance(spec.shrunk)) finish.texture_shrink = rng.Pick(kShrinks);
  finish.exposure = Factor(spec.exposure, spec.exposure, &rng);
  finish.contrast = Factor(spec.contrast, spec.contrast, &rng);
  finish.saturation = Factor(spec.saturation, spec.saturation / 2, &rng);
  for (double& tint : finish.tint) tint = Factor(spec.tint, spec.tint, &rng);
  if (finish.surfaces == sim::Surfaces::kAllWhite) Whiten(rng.Fork("white"), &finish);
  finish.blank_walls = rng.Fork("walls").Chance(spec.blank_walls);
  finish.repaint = DrawRepaint(spec, rng.Fork("repaint"));
  finish.damage = DrawDamage(spec, rng);
  finish.black_overhead = finish.ceiling && rng.Fork("overhead").Chance(spec.black_overhead);
  return finish;
}

}  // namespace bulletnav::bench
