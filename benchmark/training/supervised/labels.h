// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>

#include "agent/models/semantic_model.h"
#include "agent/perception/relative_pose.h"
#include "sim/math/pose.h"

namespace bulletnav::bench {

/// What a model is to learn of an ordered pair of panoramas, source and goal; 16 bytes, for there
/// are millions. Direction and distance are true of every pair and of use where same_node is 1,
/// scores are true of every pair and of use where it is 0.
/// Source: Neural Topological SLAM, appendix B.
struct PairLabel {
  std::uint8_t same_node = 0;  // 0 or 1: the goal can be seen, within r
  std::uint8_t direction = 0;  // bin of the goal's bearing, 0 to 11
  std::uint16_t distance = 0;  // level, in millimetres; 65535: that or more
  std::array<std::uint8_t, agent::kDirections> score = {};  // 255 is a score of 1

  /// Metres.
  float distance_m() const { return static_cast<float>(distance) * 1e-3f; }
  /// max(1 - d / r, 0) of the distance.
  float near_score() const;
  /// max(1 - d_i / d_max, 0), d_i the geodesic distance from the farthest point in direction i to
  /// the goal; rounded to 1/255, 8 cm.
  float far_score(int direction_index) const {
    return static_cast<float>(score[static_cast<std::size_t>(direction_index)]) / 255.0f;
  }
  bool operator==(const PairLabel&) const = default;
};
static_assert(sizeof(PairLabel) == 16);

using agent::BearingOf;
using agent::DirectionOf;

/// Where one comes to from a pose by going straight in a direction; at the pose's height.
sim::BodyPose PointAlong(const sim::BodyPose& from, int direction, double distance);

/// max(1 - distance / d_max, 0) in 255ths; 0 for infinity.
std::uint8_t QuantisedFarScore(double distance);

/// A label with direction and distance; neither same_node nor scores.
PairLabel LabelPose(const sim::PlanarPose& goal_in_source);

}  // namespace bulletnav::bench
