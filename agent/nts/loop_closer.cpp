// SPDX-License-Identifier: MIT
#include "agent/nts/loop_closer.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "agent/nts/settle_graph.h"
#include "agent/perception/relative_pose.h"
#include "sim/base/elementary.h"
#include "sim/base/error.h"

namespace bulletnav::agent {
namespace {

constexpr double kWayOff = 0.02;                    // metres a root of a metre,
constexpr double kTurnOff = sim::DegToRad(0.3);     // radians a root of 10 degrees,
constexpr double kTurn = sim::DegToRad(10.0);       // odometry is off, its turns mended
constexpr double kStill = 0.01;                     // metres and radians at least
constexpr double kPlaceOff = 0.3;                   // metres that F_R is off,
constexpr double kBearingOff = sim::DegToRad(8.0);  // radians that its bearings are,
constexpr double kNearOff = 0.15;                   // and metres that what is seen so is aside
constexpr double kDisagree = 0.75;                  // metres between the two ways

double Squared(double x) {
  return x * x;
}

/// Of variances: of either coordinate, in square metres, and of the yaw.
Eigen::Matrix3d InformationOf(double place, double yaw) {
  return Eigen::Vector3d(1.0 / place, 1.0 / place, 1.0 / yaw).asDiagonal();
}

}  // namespace

void LoopSpec::Validate() const {
  if (!(certainty > 0.0 && certainty < 1.0)) {
    throw sim::Error("certainty must lie between 0 and 1");
  }
  if (!(least_way >= 0.0 && apart > 0.0)) {
    throw sim::Error("least_way must not be negative, and apart must be positive");
  }
}

void LoopCloser::Reset() {
  *this = LoopCloser(spec_);
}

void LoopCloser::Move(const sim::PlanarPose& pose) {
  way_ += std::hypot(pose.x - pose_.x, pose.y - pose_.y);
  turned_ += std::fabs(sim::WrapAngle(pose.yaw - pose_.yaw));
  pose_ = pose;
}

int LoopCloser::AddPlace() {
  const int vertex = static_cast<int>(graph_.vertices.size());
  graph_.vertices.push_back({vertex, pose_, false});
  if (last_ >= 0) {
    PoseEdge<sim::PlanarPose> edge;
    edge.from = last_;
    edge.to = vertex;
    edge.measured = sim::Compose(sim::Inverse(last_pose_), pose_);
    const double way = way_ - way_there_;
    const double yaw = Squared(kStill) + Squared(kTurnOff) * turned_ / kTurn;
    const double place = Squared(kStill) + Squared(kWayOff) * way + 0.25 * Squared(way) * yaw;
    edge.information = InformationOf(place, yaw);
    graph_.edges.push_back(edge);
  }
  last_ = vertex;
  last_pose_ = pose_;
  way_there_ = way_;
  turned_ = 0.0;
  return vertex;
}

void LoopCloser::AddNode() {
  nodes_.push_back(AddPlace());
  last_tied_.push_back(way_);
}

bool LoopCloser::IsDue() const {
  return spec_.close && !nodes_.empty() && way_ - last_loop_ >= spec_.apart;
}

bool LoopCloser::IsOld(int node) const {
  return way_ - last_tied_[static_cast<std::size_t>(node)] >= spec_.least_way;
}

std::optional<PoseEdge<sim::PlanarPose>> LoopCloser::EdgeOf(const Sight& sight) const {
  const bool is_certain =
      sight.of_body.same_node >= spec_.certainty && sight.of_node.same_node >= spec_.certainty;
  const RelativeGoal body = RelativePoseOf(sight.of_body);
  const RelativeGoal node = RelativePoseOf(sight.of_node);
  if (!is_certain || std::fabs(body.distance - node.distance) > kDisagree) return std::nullopt;
  const double distance = 0.5 * (body.distance + node.distance);
  PoseEdge<sim::PlanarPose> edge;
  edge.measured = {distance * sim::Cos(body.bearing), distance * sim::Sin(body.bearing),
                   sim::WrapAngle(body.bearing + sim::kPi - node.bearing)};
  const double yaw =
      2.0 * (Squared(kBearingOff) + Squared(kNearOff / std::max(distance, 0.5 * kNearOff)));
  edge.information = InformationOf(Squared(kPlaceOff), yaw);
  edge.is_loop = true;
  return edge;
}

std::optional<std::vector<sim::PlanarPose>> LoopCloser::Close(std::span<const Sight> sights) {
  std::vector<PoseEdge<sim::PlanarPose>> loops;
  for (const Sight& sight : sights) {
    const auto edge = EdgeOf(sight);
    if (!edge) continue;
    loops.push_back(*edge);
    loops.back().from = nodes_[static_cast<std::size_t>(sight.node)];
    last_tied_[static_cast<std::size_t>(sight.node)] = way_;
  }
  if (loops.empty()) return std::nullopt;
  const int here = AddPlace();
  last_loop_ = way_;
  for (PoseEdge<sim::PlanarPose>& loop : loops) {
    loop.to = here;
    graph_.edges.push_back(std::move(loop));
  }
  const auto there = static_cast<std::size_t>(here);
  graph_.vertices[there].is_fixed = true;
  SettleGraph({}, &graph_);
  graph_.vertices[there].is_fixed = false;
  std::vector<sim::PlanarPose> poses;
  poses.reserve(nodes_.size());
  for (const int vertex : nodes_) {
    poses.push_back(graph_.vertices[static_cast<std::size_t>(vertex)].pose);
  }
  return poses;
}

}  // namespace bulletnav::agent
