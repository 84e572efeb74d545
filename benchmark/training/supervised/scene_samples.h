// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "benchmark/training/supervised/data_config.h"
#include "benchmark/training/supervised/labels.h"
#include "sim/math/pose.h"
#include "sim/world.h"

namespace bulletnav::bench {

/// Places of one scene and what is to be learnt of them; not their panoramas, see ScenePanoramas.
struct SceneSamples {
  /// Centimetres that one gets in each direction.
  using Reach = std::array<std::uint16_t, agent::kDirections>;

  std::vector<sim::BodyPose> poses;       // [n]
  std::vector<std::uint16_t> explorable;  // [n]; bit i: direction i is
  std::vector<Reach> reach;               // [n]; what the scores are measured from
  std::vector<PairLabel> pairs;           // [n, n], source after source

  int count() const { return static_cast<int>(poses.size()); }
  bool IsExplorable(int sample, int direction) const {
    return ((explorable[static_cast<std::size_t>(sample)] >> direction) & 1) != 0;
  }
  const PairLabel& pair(int source, int goal) const {
    return pairs[static_cast<std::size_t>(source) * poses.size() + static_cast<std::size_t>(goal)];
  }
  /// The farthest point seen and walkable in a direction; the sample's own place if there is none.
  sim::BodyPose FarPoint(int sample, int direction) const;
};

/// Draws points in a scene and labels them and all their pairs. Directions without a point to walk
/// to are scored from the source itself. A function of the scene's mesh and name and of the config.
/// Throws sim::Error if the scene has no floor to stand on.
/// Cost: some seconds for 300 points, most of it panoramas of depth.
SceneSamples MakeSceneSamples(const sim::World& world, const DataConfig& config);

}  // namespace bulletnav::bench
