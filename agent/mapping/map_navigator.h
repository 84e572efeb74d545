// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "agent/mapping/felt_edges.h"
#include "agent/mapping/frontier.h"
#include "agent/mapping/metric_map.h"
#include "agent/mapping/path_planner.h"
#include "agent/mapping/progress_watch.h"
#include "agent/mapping/scan_match.h"
#include "agent/mapping/visual_compass.h"
#include "agent/observation.h"
#include "sim/base/action.h"

namespace bulletnav::agent {

/// Metres and degrees. Defaults: Active Neural SLAM's, unless said otherwise.
struct NavigatorSpec {
  MapSpec map;
  double ahead = 0.25;               // to the short-term goal
  double turn_threshold_deg = 15.0;  // off by more: turn, else go forward
  double blocked_below = 0.20;       // a forward move shorter than this felt a wall
  double stuck_below = 0.05;         // shorter than this it is stuck, and the wall grows
  int widest_wall = 9;               // cells
  int least_frontier = 4;            // cells; ours
  bool match_scans = true;           // mend the odometry by depth, if there is any; ours
  bool match_views = false;          // mend its turns by colour, if there is no depth; ours
  bool feel_edges = false;           // where it was stopped often, see FeltEdges; ours

  template <class V>
  void Visit(V& v) {
    v("map", map);
    v("ahead", ahead);
    v("turn_threshold_deg", turn_threshold_deg);
    v("blocked_below", blocked_below);
    v("stuck_below", stuck_below);
    v("widest_wall", widest_wall);
    v("least_frontier", least_frontier);
    v("match_scans", match_scans);
    v("match_views", match_views);
    v("feel_edges", feel_edges);
  }
  void Validate() const;
};

/// What agents with a metric map share: where the body believes to be, its map, and how to get from
/// there to a point: the local policy of Neural Topological SLAM.
///   navigator.Reset();
///   each step: navigator.Observe(observation); ... navigator.Took(action);
class MapNavigator {
 public:
  /// See MetricMap. Throws Error for match_views without depth where VisualCompass does not serve.
  MapNavigator(const Rig& rig, const NavigatorSpec& spec,
               std::shared_ptr<FreeSpaceModel> mapper = nullptr);
  /// Maps by another view, such as a simulated one, and takes the odometry as it is. `can_doubt`:
  /// forgets a map that is contradicted.
  MapNavigator(const NavigatorSpec& spec, std::unique_ptr<ViewWindow> view, bool can_doubt);

  void Reset();
  /// Moves the pose by the odometry, mended by what is seen, marks felt walls, adds what is seen to
  /// the map. A map that what is seen contradicts for some steps has been turned by drift: it is
  /// forgotten but for the view. Throws Error if the odometry is broken.
  void Observe(const Observation& observation);
  /// The action chosen; the next observation shows what came of it.
  void Took(sim::Action action) { last_action_ = action; }

  const sim::PlanarPose& pose() const { return pose_; }
  Point here() const { return {pose_.x, pose_.y}; }
  const MetricMap& map() const { return map_; }
  /// Square metres of floor and walls seen since Reset. After the map was forgotten it grows only
  /// when more is known than ever before.
  double seen_area() const;
  /// For a map that leaves no way out: forgets felt walls, or everything but edges that were felt
  /// (see FeltEdges), which go if the next plan finds no way either.
  void ForgetFeltWalls();
  void ForgetMap();

  /// The point in the agent's plane of a place seen from the body.
  Point PointAt(double distance, double bearing) const;
  std::optional<Waypoint> Plan(const Point& goal, bool through_unknown);
  /// PathPlanner::PlaceNear, through what is unknown too.
  std::optional<Point> PlaceNear(const Point& point, std::span<const Point> others, double apart);
  /// The turn or move towards a point nearby.
  sim::Action Steer(const Point& point);

  /// The nearest frontier of the explored floor, kept until it is explored so that the body does
  /// not waver between two; absent if there is none.
  std::optional<Point> Frontier();
  /// The way to it. One that no way leads to any more, or that does not come nearer, is given up
  /// for another: something may be there that is not seen. Absent if there is none.
  std::optional<Waypoint> ToFrontier();
  /// What the last of the two found.
  const std::optional<Point>& frontier() const { return frontier_; }

  /// Where known floor ends within `reach` metres of way, the nearest first, `apart` metres from
  /// each other.
  std::vector<Point> Openings(double reach, double apart);

  /// Whether known floor ends within `radius` metres of a point; also where the map does not reach.
  bool MayLeadOn(const Point& point, double radius) const;

 private:
  MapNavigator(const NavigatorSpec& spec, MetricMap map, bool can_doubt);
  /// The motion of the last step, mended.
  sim::PlanarPose Mended(const Observation& observation);
  void FeelWalls(const sim::PlanarPose& before);
  void MarkEdges();
  void DoubtMap(const Panorama& panorama);
  void GiveUpFrontier();
  bool HasFrontierNear(const Point& point, double radius) const;

  NavigatorSpec spec_;
  std::optional<ScanMatch> match_;
  std::optional<VisualCompass> compass_;
  MetricMap map_;
  PathPlanner planner_;
  FrontierFinder frontiers_;
  FeltEdges edges_;
  bool was_forgotten_ = false;  // the map, since the last plan
  sim::PlanarPose pose_;
  sim::Action last_action_ = sim::Action::kStop;
  sim::Action last_turn_ = sim::Action::kTurnLeft;
  std::optional<double> heading_;  // to where it last steered
  int wall_width_ = 1;
  int pushes_ = 0;  // in a row that moved nothing
  std::optional<Point> frontier_;
  int frontier_number_ = 0;
  ProgressWatch frontier_watch_;
  bool can_doubt_;              // the map; a mapper from colour errs too often
  int doubts_ = 0;              // steps in a row
  std::int64_t most_seen_ = 0;  // cells
};

}  // namespace bulletnav::agent
