// SPDX-License-Identifier: MIT
#include "sim/scene/damage.h"

#include <algorithm>
#include <string>

#include "sim/base/error.h"
#include "sim/math/rng.h"
#include "sim/scene/clutter.h"
#include "sim/scene/doubled.h"
#include "sim/scene/holes.h"
#include "sim/scene/low_poly.h"
#include "sim/scene/mesh_measures.h"
#include "sim/scene/refine.h"
#include "sim/scene/smears.h"
#include "sim/scene/smooth_noise.h"

namespace bulletnav::sim {
namespace {

void Require(const char* name, double value, double low, double high) {
  if (value >= low && value <= high) return;
  const auto text = [](double number) {
    std::string digits = std::to_string(number);
    digits.erase(digits.find_last_not_of('0') + 1);
    if (digits.back() == '.') digits.pop_back();
    return digits;
  };
  throw Error(std::string(name) + " must lie between " + text(low) + " and " + text(high));
}

/// Independent numbers for the kinds of damage.
enum class Part : std::uint64_t { kClutter, kBumps, kDoubled, kHoles, kMirror, kSmears };

std::uint64_t SeedOf(const Damage& damage, Part part) {
  return MixSeed(damage.seed, static_cast<std::uint64_t>(part));
}

/// Moves points by where they are alone, so that what touches goes on touching.
void RaiseBumps(const Bumps& bumps, std::uint64_t seed, SceneMesh* mesh) {
  constexpr double kEdgesToABump = 2.0;
  constexpr float kOfFloors = 0.3f;  // they stay nearly where they were
  if (bumps.height <= 0.0) return;
  RefineTo(bumps.size / kEdgesToABump, mesh);
  const SmoothNoise x(MixSeed(seed, 0), bumps.size);
  const SmoothNoise y(MixSeed(seed, 1), bumps.size);
  const SmoothNoise z(MixSeed(seed, 2), bumps.size);
  const auto height = static_cast<float>(bumps.height);
  for (Eigen::Vector3f& p : mesh->positions) {
    const Eigen::Vector3f move(x.At(p), kOfFloors * y.At(p), z.At(p));
    p += height * move;
  }
}

}  // namespace

void Holes::Validate() const {
  Require("the share of holes", share, 0.0, 0.9);
  Require("the size of holes", size, 0.05, 10.0);
}

void Bumps::Validate() const {
  Require("the height of bumps", height, 0.0, 0.1);
  Require("the size of bumps", size, 0.05, 10.0);
}

void Smears::Validate() const {
  Require("the share of smears", share, 0.0, 1.0);
  Require("the length of smears", length, 0.0, 1.0);
}

void Doubled::Validate() const {
  Require("the share of doubled", share, 0.0, 1.0);
  Require("the offset of doubled", offset, 0.0, 0.2);
}

void Damage::Validate() const {
  Require("low_poly", low_poly, 0.0, 1.0);
  if (color_spacing != 0.0) Require("color_spacing, if not 0,", color_spacing, 0.02, 10.0);
  Require("clutter", clutter, 0.0, 50.0);
  Require("mirrored", mirrored, 0.0, 1.0);
  bumps.Validate();
  doubled.Validate();
  holes.Validate();
  smears.Validate();
}

void ApplyDamage(const Damage& damage, SceneMesh* mesh) {
  damage.Validate();
  ClusterVertices(damage.low_poly, mesh);
  PaintVertices(damage.color_spacing, mesh);
  AddClutter(damage.clutter, SeedOf(damage, Part::kClutter), mesh);
  RaiseBumps(damage.bumps, SeedOf(damage, Part::kBumps), mesh);
  DoubleSurfaces(damage.doubled, SeedOf(damage, Part::kDoubled), mesh);
  PunchHoles(damage.holes, SeedOf(damage, Part::kHoles), mesh);
  MirrorFloor(damage.mirrored, SeedOf(damage, Part::kMirror), mesh);
  SmearColors(damage.smears, SeedOf(damage, Part::kSmears), mesh);
}

}  // namespace bulletnav::sim
