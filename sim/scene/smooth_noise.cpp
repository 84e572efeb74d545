// SPDX-License-Identifier: MIT
#include "sim/scene/smooth_noise.h"

#include <array>
#include <cmath>

#include "sim/math/rng.h"

namespace bulletnav::sim {
namespace {

constexpr float kFiner = 3.0f;
constexpr std::uint64_t kFineSeed = 0x9e3779b97f4a7c15u;

/// The number at a corner of the lattice, of a column's hash.
float Corner(std::uint64_t column, std::int64_t z) {
  constexpr int kBits = 24;  // as many as a float holds
  const std::uint64_t hash = MixSeed(column, static_cast<std::uint64_t>(z));
  constexpr float kScale = 2.0f / static_cast<float>(1 << kBits);
  return static_cast<float>(hash >> (64 - kBits)) * kScale - 1.0f;
}

float Blend(float a, float b, float t) {
  return a + (b - a) * t;
}

float FieldAt(std::uint64_t seed, const Eigen::Vector3f& p) {
  std::array<std::int64_t, 3> at{};
  std::array<float, 3> t{};
  for (int i = 0; i < 3; ++i) {
    const float low = std::floor(p[i]);
    const float f = p[i] - low;
    at[static_cast<std::size_t>(i)] = static_cast<std::int64_t>(low);
    t[static_cast<std::size_t>(i)] = f * f * (3.0f - 2.0f * f);
  }
  const std::array<std::uint64_t, 2> rows = {MixSeed(seed, static_cast<std::uint64_t>(at[0])),
                                             MixSeed(seed, static_cast<std::uint64_t>(at[0] + 1))};
  std::array<float, 4> columns{};  // at the corners of a square across x and y
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const std::int64_t y = at[1] + static_cast<std::int64_t>(k >> 1);
    const std::uint64_t column = MixSeed(rows[k & 1], static_cast<std::uint64_t>(y));
    columns[k] = Blend(Corner(column, at[2]), Corner(column, at[2] + 1), t[2]);
  }
  return Blend(Blend(columns[0], columns[1], t[0]), Blend(columns[2], columns[3], t[0]), t[1]);
}

}  // namespace

float SmoothNoise::At(const Eigen::Vector3f& point) const {
  return FieldAt(seed_, point / cell_);
}

float SmoothNoise::RoughAt(const Eigen::Vector3f& point) const {
  return FieldAt(seed_, point / cell_) +
         FieldAt(seed_ ^ kFineSeed, point * (kFiner / cell_)) / kFiner;
}

}  // namespace bulletnav::sim
