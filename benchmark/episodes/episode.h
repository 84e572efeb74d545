// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "sim/math/pose.h"

namespace bulletnav::bench {

/// By geodesic distance from start to goal: easy [1.5, 3), medium [3, 5), hard [5, 10] metres.
/// Source: Neural Topological SLAM, section 5. For larger buildings, ours: very hard (10, 20),
/// extreme [20, 40].
enum class Difficulty { kEasy, kMedium, kHard, kVeryHard, kExtreme };

inline constexpr std::array kDifficulties = {Difficulty::kEasy, Difficulty::kMedium,
                                             Difficulty::kHard, Difficulty::kVeryHard,
                                             Difficulty::kExtreme};

/// "easy", "medium", "hard", "very_hard", "extreme".
std::string_view DifficultyName(Difficulty difficulty);
std::optional<Difficulty> DifficultyNamed(std::string_view name);
/// The one whose band holds the distance, if any does.
std::optional<Difficulty> DifficultyAt(double geodesic_distance);

/// Heading of an upright body as Habitat's files give it: the unit quaternion (x, y, z, w) of the
/// turn about +y. Habitat's world is ours (y up, no turn looks along -z, positive turns left), so
/// yaw = 2 atan2(y, w) is sim::BodyPose's. Kept as a quaternion, so that no file changes in its
/// last digits by being read and written.
struct Rotation {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
  double w = 1.0;

  static Rotation FromYaw(double yaw);
  /// In (-pi, pi].
  double yaw() const;
  bool operator==(const Rotation&) const = default;
};

struct EpisodeGoal {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  // on the floor
  std::optional<Rotation> rotation;  // of the camera that takes the goal's panorama
  std::optional<double> radius;      // metres; what files say, not what success is measured by
  double geodesic_distance = 0.0;    // metres from the start, or from the goal before this one

  bool operator==(const EpisodeGoal& other) const;
};

/// One task: from a start to a goal, or to several goals one after the other. Positions are in the
/// scene's world frame, metres, y up, on the floor.
struct Episode {
  std::string id;     // unique among the episodes of its scene
  std::string scene;  // the mesh's file: a path, or one below a folder of scenes as Habitat has it
  Eigen::Vector3d start_position = Eigen::Vector3d::Zero();
  Rotation start_rotation;
  std::vector<EpisodeGoal> goals;  // at least one
  std::optional<Difficulty> difficulty;
  /// What a file said about the episode beyond the above, or in another order: its JSON object.
  /// Written back to the letter, with the members above in their places. Empty if there is none.
  std::string source;

  sim::BodyPose start() const;
  /// Where the camera takes goal i's panorama. A goal without a heading of its own gets one that is
  /// drawn from the episode's scene and id.
  sim::BodyPose goal(std::size_t i) const;
  bool operator==(const Episode& other) const;
};

}  // namespace bulletnav::bench
