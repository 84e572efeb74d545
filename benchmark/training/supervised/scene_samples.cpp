// SPDX-License-Identifier: MIT
#include "benchmark/training/supervised/scene_samples.h"

#include <cmath>
#include <optional>

#include "benchmark/training/supervised/goal_sight.h"
#include "benchmark/training/supervised/near_map.h"
#include "benchmark/training/supervised/sample_points.h"
#include "benchmark/training/supervised/scene_panoramas.h"
#include "benchmark/training/supervised/walk_grid.h"

namespace bulletnav::bench {
namespace {

using agent::kDirections;
using sim::Cell;

constexpr double kReachStep = 0.05;  // metres

/// Labels the points of one scene, in the order of its methods.
class Labeller {
 public:
  Labeller(const sim::World& world, const DataConfig& config)
      : storey_(LargestStorey(world.navmesh())),
        query_(world.navmesh()),
        grid_(world.navmesh(), storey_),
        panoramas_(world.render_scene(), config),
        sight_(config.panorama),
        map_(config),
        depth_(config.panorama.pixels()) {
    samples_.poses = DrawPoints(world, storey_, config);
    samples_.pairs.resize(samples_.poses.size() * samples_.poses.size());
  }

  /// What a source's own depth tells.
  void LookAround() {
    for (int source = 0; source < samples_.count(); ++source) {
      panoramas_.Render(samples_.poses, {&source, 1}, {}, depth_);
      LabelDirections(source);
      LabelSight(source);
    }
  }

  void MeasureScores() {
    for (int sample = 0; sample < samples_.count(); ++sample) {
      for (int i = 0; i < kDirections; ++i) {
        const sim::BodyPose point = samples_.FarPoint(sample, i);
        far_.push_back({point.position, grid_.CellAt(point.position)});
      }
    }
    WalkDistances distances(grid_);
    for (int goal = 0; goal < samples_.count(); ++goal) {
      const Eigen::Vector3d& at = samples_.poses[static_cast<std::size_t>(goal)].position;
      const auto cell = grid_.CellAt(at);
      if (cell) distances.MeasureFrom(*cell);
      for (std::size_t k = 0; k < far_.size(); ++k) {
        const bool both = cell && far_[k].cell;
        const double on_grid = both ? distances.To(*far_[k].cell) : HUGE_VAL;
        // Where cells are too coarse for a way there may be one nevertheless.
        const double d = std::isfinite(on_grid) ? on_grid : Detour(far_[k].point, at);
        PairLabel& label = Pair(static_cast<int>(k) / kDirections, goal);
        label.score[k % kDirections] = QuantisedFarScore(d);
      }
    }
  }

  SceneSamples Finish() { return std::move(samples_); }

 private:
  struct FarPlace {
    Eigen::Vector3d point;
    std::optional<sim::Cell> cell;
  };

  PairLabel& Pair(int source, int goal) {
    return samples_.pairs[static_cast<std::size_t>(source) * samples_.poses.size() +
                          static_cast<std::size_t>(goal)];
  }

  double Detour(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const {
    return query_.GeodesicDistance(from.cast<float>(), to.cast<float>());
  }

  void LabelDirections(int source) {
    map_.Project(depth_);
    unsigned explorable = 0;
    SceneSamples::Reach reach{};
    for (int i = 0; i < kDirections; ++i) {
      if (map_.IsExplorable(i)) explorable |= 1u << i;
      reach[static_cast<std::size_t>(i)] = ReachOnFloor(source, i);
    }
    samples_.explorable.push_back(static_cast<std::uint16_t>(explorable));
    samples_.reach.push_back(reach);
  }

  /// The map knows what is in the way, not whether there is a floor to walk on.
  std::uint16_t ReachOnFloor(int source, int direction) const {
    const sim::BodyPose& pose = samples_.poses[static_cast<std::size_t>(source)];
    for (auto steps = std::lround(map_.Reach(direction) / kReachStep); steps > 0; --steps) {
      const double reach = static_cast<double>(steps) * kReachStep;
      if (!grid_.CellAt(PointAlong(pose, direction, reach).position)) continue;
      return static_cast<std::uint16_t>(std::lround(1e2 * reach));
    }
    return 0;
  }

  void LabelSight(int source) {
    const sim::BodyPose& from = samples_.poses[static_cast<std::size_t>(source)];
    for (int goal = 0; goal < samples_.count(); ++goal) {
      const sim::BodyPose& to = samples_.poses[static_cast<std::size_t>(goal)];
      const sim::PlanarPose relative = RelativePose(from, to);
      const double rise = to.position.y() - from.position.y();
      PairLabel label = LabelPose(relative);
      label.same_node = sight_.IsSameNode(depth_, relative, rise) ? 1 : 0;
      Pair(source, goal) = label;
    }
  }

  Storey storey_;
  sim::NavmeshQuery query_;
  WalkGrid grid_;
  ScenePanoramas panoramas_;
  GoalSight sight_;
  NearMap map_;
  std::vector<float> depth_;
  std::vector<FarPlace> far_;  // [n, directions]
  SceneSamples samples_;
};

}  // namespace

sim::BodyPose SceneSamples::FarPoint(int sample, int direction) const {
  const auto s = static_cast<std::size_t>(sample);
  const double metres = 1e-2 * reach[s][static_cast<std::size_t>(direction)];
  return PointAlong(poses[s], direction, metres);
}

SceneSamples MakeSceneSamples(const sim::World& world, const DataConfig& config) {
  world.RequireFloor();
  Labeller labeller(world, config);
  labeller.LookAround();
  labeller.MeasureScores();
  return labeller.Finish();
}

}  // namespace bulletnav::bench
