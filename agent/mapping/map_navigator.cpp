// SPDX-License-Identifier: MIT
#include "agent/mapping/map_navigator.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/base/elementary.h"
#include "sim/base/error.h"

namespace bulletnav::agent {
namespace {

constexpr double kAboutFace = sim::DegToRad(150.0);  // beyond it the last turn's sense is kept
constexpr double kSameFrontier = 0.25;               // metres
constexpr double kTooFar = 10.0;                     // metres in one step
constexpr double kArrived = 0.3;   // metres from a frontier; what is still unseen there stays so
constexpr int kPatience = 30;      // steps in which a frontier does not come nearer
constexpr double kNearer = 0.25;   // metres
constexpr int kFrontiers = 8;      // looked at in one step
constexpr double kTurned = 0.25;   // of the map's obstacles in sight looked through
constexpr int kFewObstacles = 60;  // cells
constexpr double kAtEdge = 1.0;    // metres; there the edge stands for the walls that were felt
constexpr int kPushes = 5;         // in a row, without turning
constexpr int kDoubts = 3;         // steps in a row

}  // namespace

void NavigatorSpec::Validate() const {
  if (!(ahead >= map.cell && ahead <= map.vision)) {
    throw sim::Error("ahead must lie between the map's cell and its vision");
  }
  if (!(turn_threshold_deg > 5.0 && turn_threshold_deg < 90.0)) {
    throw sim::Error("turn_threshold_deg must lie between 5, half a turn, and 90");
  }
  if (!(stuck_below <= blocked_below) || widest_wall < 1 || least_frontier < 1) {
    throw sim::Error("expected stuck_below <= blocked_below, widest_wall and least_frontier >= 1");
  }
}

MapNavigator::MapNavigator(const Rig& rig, const NavigatorSpec& spec,
                           std::shared_ptr<FreeSpaceModel> mapper)
    : MapNavigator(spec, MetricMap(rig, spec.map, std::move(mapper)), rig.has_depth) {
  if (rig.has_depth && spec.match_scans) match_.emplace(rig);
  if (rig.has_depth || !spec.match_views) return;
  if (!VisualCompass::Serves(rig)) {
    throw sim::Error(
        "match_views needs a panorama in colour with columns of equal angles, which "
        "cube_strip has not; leave it out");
  }
  compass_.emplace(rig);
}

MapNavigator::MapNavigator(const NavigatorSpec& spec, std::unique_ptr<ViewWindow> view,
                           bool can_doubt)
    : MapNavigator(spec, MetricMap(spec.map, std::move(view), sim::PlanarPose{}), can_doubt) {}

MapNavigator::MapNavigator(const NavigatorSpec& spec, MetricMap map, bool can_doubt)
    : spec_(spec),
      map_(std::move(map)),
      planner_(spec.map, spec.ahead),
      frontiers_(spec.map.cells(), spec.least_frontier),
      frontier_watch_(kPatience, kNearer),
      can_doubt_(can_doubt) {}

void MapNavigator::Reset() {
  pose_ = {};
  map_.Clear(pose_);
  if (match_) match_->Reset();
  if (compass_) compass_->Reset();
  last_action_ = sim::Action::kStop;
  last_turn_ = sim::Action::kTurnLeft;
  wall_width_ = 1;
  pushes_ = 0;
  frontier_.reset();
  frontier_watch_.Reset();
  doubts_ = 0;
  heading_.reset();
  edges_.Reset();
  was_forgotten_ = false;
  most_seen_ = 0;
}

double MapNavigator::seen_area() const {
  const double cell = spec_.map.cell;
  return static_cast<double>(most_seen_) * cell * cell;
}

void MapNavigator::Observe(const Observation& observation) {
  const sim::PlanarPose& motion = observation.odometry;
  if (!std::isfinite(motion.x + motion.y + motion.yaw) ||
      std::hypot(motion.x, motion.y) > kTooFar) {
    throw sim::Error("the odometry reads what no step can have done");
  }
  const sim::PlanarPose before = pose_;
  pose_ = sim::Compose(pose_, Mended(observation));
  map_.MarkTrack(before, pose_);
  FeelWalls(before);
  map_.Update(observation.panorama, pose_);
  DoubtMap(observation.panorama);
  most_seen_ = std::max(most_seen_, map_.seen_cells());
}

sim::PlanarPose MapNavigator::Mended(const Observation& observation) {
  if (match_) return match_->Match(observation.panorama, observation.odometry);
  if (compass_) return compass_->Match(observation.panorama, observation.odometry);
  return observation.odometry;
}

void MapNavigator::DoubtMap(const Panorama& panorama) {
  const MetricMap::Contradiction& found = map_.contradiction();
  const bool is_doubtful = can_doubt_ && found.all >= kFewObstacles && found.share() >= kTurned;
  doubts_ = is_doubtful ? doubts_ + 1 : 0;
  if (doubts_ < kDoubts) return;
  doubts_ = 0;
  ForgetMap();
  map_.Update(panorama, pose_);
}

void MapNavigator::FeelWalls(const sim::PlanarPose& before) {
  if (last_action_ != sim::Action::kMoveForward) {
    pushes_ = 0;
    return;
  }
  const double moved = std::hypot(pose_.x - before.x, pose_.y - before.y);
  wall_width_ = moved < spec_.stuck_below ? std::min(wall_width_ + 2, spec_.widest_wall) : 1;
  pushes_ = moved < spec_.stuck_below ? pushes_ + 1 : 0;
  if (moved >= spec_.blocked_below) return;
  if (pushes_ > kPushes && !edges_.segments().empty()) {
    // What is marked may be what makes it push at one place.
    edges_.Reset();
    map_.ForgetFeltWalls(here(), kAtEdge);
    pushes_ = 0;
  } else if (spec_.feel_edges && edges_.Feel(pose_)) {
    map_.ForgetFeltWalls(here(), kAtEdge);
    MarkEdges();
  }
  map_.MarkWall(before, wall_width_);
}

void MapNavigator::MarkEdges() {
  for (const FeltEdges::Segment& edge : edges_.segments()) map_.MarkEdge(edge.from, edge.to);
}

void MapNavigator::ForgetFeltWalls() {
  edges_.Reset();
  map_.ForgetFeltWalls();
}

void MapNavigator::ForgetMap() {
  map_.Clear(pose_);
  MarkEdges();
  was_forgotten_ = true;
}

Point MapNavigator::PointAt(double distance, double bearing) const {
  const double heading = pose_.yaw + bearing;
  return {pose_.x + distance * sim::Cos(heading), pose_.y + distance * sim::Sin(heading)};
}

std::optional<Waypoint> MapNavigator::Plan(const Point& goal, bool through_unknown) {
  const PathPlanner::Query query{here(), goal, through_unknown, heading_};
  const std::optional<Waypoint> plan = planner_.Plan(map_, query);
  const bool was_forgotten = std::exchange(was_forgotten_, false);
  if (plan || !was_forgotten || !through_unknown || edges_.segments().empty()) return plan;
  // They were taken to go on too far, and shut something in.
  ForgetFeltWalls();
  return planner_.Plan(map_, query);
}

std::optional<Point> MapNavigator::PlaceNear(const Point& point, std::span<const Point> others,
                                             double apart) {
  return planner_.PlaceNear(map_, {here(), point, true}, others, apart);
}

sim::Action MapNavigator::Steer(const Point& point) {
  const double heading = sim::Atan2(point.y - pose_.y, point.x - pose_.x);
  heading_ = heading;
  const double off = sim::WrapAngle(heading - pose_.yaw);
  if (std::fabs(off) <= sim::DegToRad(spec_.turn_threshold_deg)) return sim::Action::kMoveForward;
  if (std::fabs(off) < kAboutFace) {
    last_turn_ = off > 0.0 ? sim::Action::kTurnLeft : sim::Action::kTurnRight;
  }
  return last_turn_;
}

std::optional<Point> MapNavigator::Frontier() {
  if (frontier_ && Distance(here(), *frontier_) < kArrived) {
    map_.MarkNoWay(*frontier_, kArrived);
    frontier_.reset();
  }
  if (frontier_ && HasFrontierNear(*frontier_, kSameFrontier)) return frontier_;
  frontier_.reset();
  const auto cell = frontiers_.Nearest(map_.states(), map_.CellAt(here()));
  if (cell) frontier_ = map_.Centre(*cell);
  ++frontier_number_;
  return frontier_;
}

std::optional<Waypoint> MapNavigator::ToFrontier() {
  for (int i = 0; i < kFrontiers && Frontier(); ++i) {
    const std::optional<Waypoint> plan = Plan(*frontier_, false);
    const bool is_stuck =
        plan && frontier_watch_.IsStuck(frontier_number_, plan->distance, seen_area());
    if (plan && !is_stuck) return plan;
    GiveUpFrontier();
  }
  frontier_.reset();
  return std::nullopt;
}

void MapNavigator::GiveUpFrontier() {
  map_.MarkNoWay(*frontier_, kArrived);
  frontier_watch_.Forget(frontier_number_);
  frontier_.reset();
}

std::vector<Point> MapNavigator::Openings(double reach, double apart) {
  std::vector<Point> points;
  const double cell = spec_.map.cell;
  for (const sim::Cell& end :
       frontiers_.Near(map_.states(), map_.CellAt(here()), reach / cell, apart / cell)) {
    points.push_back(map_.Centre(end));
  }
  return points;
}

bool MapNavigator::MayLeadOn(const Point& point, double radius) const {
  const sim::Cell cell = map_.CellAt(point);
  const bool is_seen =
      map_.states().Contains(cell) && map_.states()[cell] != sim::CellState::kUnknown;
  return !is_seen || HasFrontierNear(point, radius);
}

bool MapNavigator::HasFrontierNear(const Point& point, double radius) const {
  const sim::Cell middle = map_.CellAt(point);
  const int reach = static_cast<int>(radius / spec_.map.cell);
  for (int dy = -reach; dy <= reach; ++dy) {
    for (int dx = -reach; dx <= reach; ++dx) {
      const sim::Cell cell{middle.x + dx, middle.y + dy};
      const bool inside = cell.x > 0 && cell.y > 0 && cell.x < map_.states().size() - 1 &&
                          cell.y < map_.states().size() - 1;
      if (inside && IsFrontier(map_.states(), cell)) return true;
    }
  }
  return false;
}

}  // namespace bulletnav::agent
