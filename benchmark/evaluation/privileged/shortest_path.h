// SPDX-License-Identifier: MIT
#pragma once
#include <optional>

#include "benchmark/evaluation/privileged/privileged_agent.h"
#include "sim/navmesh/navmesh.h"
#include "sim/physics/capsule_body.h"

namespace bulletnav::bench {

/// Follows the geodesic greedily: turns towards the next corner of the shortest path, goes forward,
/// and plans again every step, so that noise does not add up. Where a wall is in the way of that,
/// it tries all headings with the physics and takes the one that brings it nearest.
class ShortestPathAgent final : public PrivilegedAgent {
 public:
  static constexpr std::string_view kName = "shortest_path";

  struct Config {
    double stop_distance = 0.5;  // metres of geodesic left

    template <class V>
    void Visit(V& v) {
      v("stop_distance", stop_distance);
    }
    void Validate() const;
  };

  explicit ShortestPathAgent(const Config& config) : config_(config) {}

  void Reset(const GroundTruth& truth) override;
  sim::Action Act(const GroundTruth& truth) override;

 private:
  double DistanceLeft(const sim::BodyPose& pose, const GroundTruth& truth) const;
  /// Geodesic that one step forward gains after `turns` turns to the left.
  double Gain(const GroundTruth& truth, int turns, double left) const;
  int BestTurns(const GroundTruth& truth, double left) const;

  Config config_;
  std::shared_ptr<const sim::World> world_;
  std::optional<sim::NavmeshQuery> query_;
  std::optional<double> way_out_;  // heading to take before anything else
};

}  // namespace bulletnav::bench
