// SPDX-License-Identifier: MIT
#pragma once
#include <deque>
#include <limits>
#include <optional>

#include "benchmark/privileged/privileged_agent.h"
#include "sim/navmesh/navmesh.h"

namespace bulletnav::bench {

/// Follows the geodesic greedily: turns towards the next corner of the shortest path, goes forward,
/// and plans again every step, so that noise does not add up. Where the physics does not let it
/// (the navmesh is coarser than the scene), it searches for a way round; see FindWayOut.
class ShortestPathAgent final : public PrivilegedAgent {
 public:
  static constexpr std::string_view kName = "shortest_path";

  struct Config {
    double stop_distance = 0.5;  // metres of geodesic left
    // Off by more, it turns. At 5, half a turn, noise makes it dither: SPL 0.73 instead of 0.98.
    double turn_tolerance_deg = 12.0;
    // No keys of configs: for teachers, whose bodies push at walls and need not go the way round
    // that is found. Actions before it searches again where it has found none, and metres from the
    // next place of a way round beyond which it is given up.
    int search_pause = 0;
    double most_stray = std::numeric_limits<double>::infinity();

    template <class V>
    void Visit(V& v) {
      v("stop_distance", stop_distance);
      v("turn_tolerance_deg", turn_tolerance_deg);
    }
    void Validate() const;
  };

  struct Advice {
    sim::Action action;
    // Whether it is known to lead to the goal: not where it stops because no way leads there, nor
    // where it pushes on because it has found no way round.
    bool leads;
  };

  explicit ShortestPathAgent(const Config& config) : config_(config) {}

  void Reset(const GroundTruth& truth) override;
  /// What is advised.
  sim::Action Act(const GroundTruth& truth) override;
  Advice Advise(const GroundTruth& truth);

 private:
  /// Turns as near as turns get to the direction of a point, then goes.
  sim::Action Towards(const Eigen::Vector3d& point, const sim::BodyPose& pose) const;
  /// Along the way out; absent if there is none or it is done.
  std::optional<sim::Action> FollowWayOut(const sim::BodyPose& pose);
  /// Geodesic that one step straight ahead gains.
  double GainAhead(const GroundTruth& truth, double left) const;

  Config config_;
  std::shared_ptr<const sim::World> world_;
  std::optional<sim::NavmeshQuery> query_;
  std::deque<Eigen::Vector3d> way_out_;
  int patience_ = 0;  // steps left for the way out, which noise may have made impassable
  int pause_ = 0;     // steps left before the next search
};

}  // namespace bulletnav::bench
