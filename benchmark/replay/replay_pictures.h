// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "benchmark/play/trajectory.h"
#include "sim/world.h"

namespace bulletnav::bench {

/// So many numbers of steps of an episode, evenly from the start to the end; fewer if it is short.
std::vector<int> SpreadSteps(std::size_t steps, int count);

/// Panoramas of an episode below each other as a small JPEG: what the body saw after `steps`, which
/// must not be empty. Throws sim::Error as ReplayPanoramas does.
std::vector<std::uint8_t> SeenStrip(const std::shared_ptr<const sim::World>& world,
                                    const EpisodeTrajectory& trajectory,
                                    const std::vector<int>& steps);
/// The same of its goals.
std::vector<std::uint8_t> GoalStrip(const sim::World& world, const EpisodeTrajectory& trajectory);

}  // namespace bulletnav::bench
