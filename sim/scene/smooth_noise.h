// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include <Eigen/Core>

namespace bulletnav::sim {

/// A smooth random field: numbers drawn at the corners of a lattice, blended between them, with a
/// finer and weaker field on top so that its level lines are rough. The same bits everywhere.
class SmoothNoise {
 public:
  /// `cell`: metres between the lattice's corners; positive.
  SmoothNoise(std::uint64_t seed, double cell) : seed_(seed), cell_(static_cast<float>(cell)) {}

  /// In [-1, 1], continuous.
  float At(const Eigen::Vector3f& point) const;
  /// At, and a third of another field of a third of the cell. In [-1.34, 1.34].
  float RoughAt(const Eigen::Vector3f& point) const;

 private:
  std::uint64_t seed_;
  float cell_;
};

}  // namespace bulletnav::sim
