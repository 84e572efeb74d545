// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "benchmark/episodes/distance_bands.h"
#include "benchmark/episodes/ground.h"
#include "sim/physics/capsule_body.h"

namespace bulletnav::bench {

/// Least geodesic/Euclidean ratio that a candidate with the random number u in [0, 1) must have to
/// be kept: asking for it keeps a ratio under 1.1 with probability 20 (ratio - 0.98)^2.
double LeastRatio(double u);

/// Draws the episodes of one scene. Start and goals: points drawn evenly from the floor of islands
/// of at least 1.5 m radius and 15% of the largest's area, where the body stands free; on one floor
/// (heights within 0.5 m), the geodesic distance in its band; a geodesic/Euclidean ratio under 1.1
/// is kept with probability 20 (ratio - 0.98)^2; all headings even. Deterministic by (seed, scene's
/// file name, kind, index): not by how many others are drawn. Source: habitat-lab's
/// pointnav_generator.
class EpisodeDrawer {
 public:
  /// `scene` and `label` become part of the episodes: their scene and the beginning of their id.
  /// The ground must outlive the drawer.
  EpisodeDrawer(const Ground& ground, std::string scene, std::string label,
                const sim::BodySpec& body, std::uint64_t seed);

  /// Throws sim::Error if the scene has no such episode, or next to none.
  Episode Draw(Difficulty difficulty, int index);
  /// Goals one after the other, each 1.5 to 5 m from the last; other rules as above.
  Episode DrawSequence(int goals, int index);

 private:
  struct Place {
    sim::BodyPose pose;
    int island = 0;
  };
  /// Whether there is lower floor of the same storey around: a table that can be climbed, a stair.
  bool IsRaised(const Eigen::Vector3f& foot) const;
  /// The body standing at a point, if it can and the point is on the floor.
  std::optional<Place> Stand(const Eigen::Vector3f& point, double yaw, int island);
  std::optional<Place> DrawStart(sim::Rng* rng);
  /// One try at a goal for `from`, its distance written to `distance`.
  std::optional<Place> DrawGoal(const Place& from, const DistanceBand& band, sim::Rng* rng,
                                double* distance);
  std::vector<EpisodeGoal> DrawGoals(const Place& start, const DistanceBand& band, int count,
                                     sim::Rng* rng);
  Episode Draw(std::string_view kind, int index, const DistanceBand& band, int goals);

  const Ground& ground_;
  std::string scene_;
  std::string label_;
  std::uint64_t seed_;
  sim::NavmeshQuery query_;
  sim::CapsuleBody body_;
  std::vector<double> island_weights_;  // m2 of those large enough, else 0
};

}  // namespace bulletnav::bench
