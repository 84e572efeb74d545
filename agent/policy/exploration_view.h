// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "agent/mapping/metric_map.h"
#include "sim/math/pose.h"

namespace bulletnav::agent {

/// What the global policy of Active Neural SLAM sees: eight maps of 240 x 240 cells, of which the
/// largest of 2 x 2 cells are kept, since that is what its network does first. Obstacles, explored
/// cells, where the body is and where it has been: of the 12 m window around the body at 5 cm, and
/// of the whole map of 24 m at 10 cm. Axes are those of the agent's plane.
inline constexpr int kExplorationSide = 120;
inline constexpr std::size_t kExplorationBytes =
    static_cast<std::size_t>(kExplorationSide) * kExplorationSide;
inline constexpr int kExplorationChannels = 8;
inline constexpr int kHeadings = 72;  // bins of 5 degrees

/// Throws Error unless maps have the size and cells that the policy sees.
void RequireExplorationMap(const MapSpec& spec);

/// One byte a pixel, row after row of rising y; bit i of it is channel i: obstacle, explored, here,
/// been in the window, then the same of the whole. Expects: kExplorationBytes, a map that
/// RequireExplorationMap lets pass (checked). Cost: 0.3 ms.
void WriteExplorationView(const MetricMap& map, const sim::PlanarPose& pose,
                          std::span<std::uint8_t> view);

/// 0 to kHeadings - 1, rising counter-clockwise from straight behind.
int HeadingBin(double yaw);

/// The middle of the cell at these shares of the sides of the window around `pose`, moved onto the
/// map where that ends before.
Point GoalAt(const MetricMap& map, const sim::PlanarPose& pose,
             const std::array<double, 2>& shares);

}  // namespace bulletnav::agent
