// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "agent/mapping/metric_map.h"
#include "agent/observation.h"
#include "sim/math/pose.h"

namespace bulletnav::agent {

/// What a policy is shown of its metric map: two square crops around the body, turned as it is, so
/// that row 0 lies ahead and column 0 to the left. Each says of its cells whether there is an
/// obstacle, whether they were seen, and whether the body has been there: a bit each.
inline constexpr int kMapSide = 64;  // cells of a crop
inline constexpr int kMapPlanes = 3;
inline constexpr int kMapCrops = 2;  // of cells of 5 cm, and of 20 cm, which tell of any of 4 x 4
inline constexpr int kMapCoarse = 4;
inline constexpr int kMapFeatures = 128;  // that a policy makes of both crops together
/// Bit [crop, plane, row, col], the lowest bit of a byte first.
inline constexpr std::size_t kPolicyMapBytes =
    std::size_t{kMapCrops} * kMapPlanes * kMapSide * kMapSide / 8;

/// Maps by depth where the odometry says that the body is, which drifts, and cuts the crops.
/// Source: Chen, Gupta and Gupta, "Learning exploration policies for navigation", 2019, for crops
/// at two scales beside the picture.
/// Cost: some 0.5 ms an observation of 128 x 512, most of it the metric map's.
class PolicyMap {
 public:
  /// Throws Error if the rig has no depth.
  explicit PolicyMap(const Rig& rig);

  /// A new episode: nothing is known.
  void Reset();
  /// Once a step. Throws Error if the odometry is broken.
  void See(const Observation& observation);
  /// [kPolicyMapBytes], of the last observation.
  std::span<const std::uint8_t> bytes() const { return bytes_; }

  const sim::PlanarPose& pose() const { return pose_; }
  const MetricMap& map() const { return map_; }

 private:
  void Cut();
  /// What is known of a cell; nothing beyond the map.
  unsigned BitsOf(const sim::Cell& at) const;
  void Turn();
  void SetBits(int crop, int row, int col, unsigned bits);

  MetricMap map_;
  sim::PlanarPose pose_;
  std::vector<std::uint8_t> turned_;  // [4 * 64, 4 * 64] cells of 5 cm around the body
  std::vector<std::uint8_t> bytes_;
};

}  // namespace bulletnav::agent
