// SPDX-License-Identifier: MIT
#include "benchmark/privileged/oracle_semantic_model.h"

#include <algorithm>
#include <cmath>

#include "benchmark/privileged/visibility.h"
#include "sim/base/check.h"
#include "sim/base/elementary.h"

namespace bulletnav::bench {
namespace {

using agent::kDirections;
using agent::kNodeRadius;

constexpr double kDetour = 1.05;      // times the straight way that still is free
constexpr double kSearchStep = 0.25;  // metres between places looked at in a direction
constexpr float kOffFloor = 0.1f;     // metres sideways to the floor that still is on it
constexpr double kDirectionWidth = 2.0 * sim::kPi / kDirections;

bool IsSameMemory(const agent::Panorama& a, const agent::Panorama& b) {
  return a.color.data() == b.color.data() && a.depth.data() == b.depth.data();
}

agent::PanoramaCode ToCode(const sim::BodyPose& pose) {
  const Eigen::Vector3f p = pose.position.cast<float>();
  return {p.x(), p.y(), p.z(), static_cast<float>(pose.yaw)};
}

sim::BodyPose ToPose(const agent::PanoramaCode& code) {
  BULLETNAV_CHECK_EQ(code.size(), 4u);
  return {Eigen::Vector3f(code[0], code[1], code[2]).cast<double>(), code[3]};
}

Eigen::Vector3f PlaceAt(const sim::BodyPose& source, int direction, double distance) {
  const double angle = kDirectionWidth * direction;
  const sim::PlanarPose place{distance * sim::Cos(angle), distance * sim::Sin(angle), 0.0};
  return sim::Apply(source, place).position.cast<float>();
}

/// One between the two directions nearest to a bearing.
void ShareDirection(double bearing, std::array<float, kDirections>* direction) {
  const double turns = bearing / kDirectionWidth + 2.0 * kDirections;
  const auto low = static_cast<int>(turns);
  const auto share = static_cast<float>(turns - low);
  (*direction)[static_cast<std::size_t>(low % kDirections)] += 1.0f - share;
  (*direction)[static_cast<std::size_t>((low + 1) % kDirections)] += share;
}

}  // namespace

std::vector<agent::PanoramaCode> OracleSemanticModel::Encode(
    std::span<const agent::Panorama> panoramas) {
  std::vector<agent::PanoramaCode> codes;
  for (const agent::Panorama& panorama : panoramas) {
    const bool is_goal = IsSameMemory(panorama, truth_.goal_panorama);
    codes.push_back(ToCode(is_goal ? truth_.goal : truth_.pose));
  }
  return codes;
}

std::array<float, kDirections> OracleSemanticModel::Explorable(const agent::PanoramaCode& source) {
  const sim::BodyPose pose = ToPose(source);
  std::array<float, kDirections> open = {};
  for (int i = 0; i < kDirections; ++i) {
    const bool is_open = IsFree(pose, PlaceAt(pose, i, kNodeRadius), kNodeRadius);
    open[static_cast<std::size_t>(i)] = is_open ? 1.0f : 0.0f;
  }
  return open;
}

std::vector<agent::PairPrediction> OracleSemanticModel::Compare(
    std::span<const agent::PanoramaCode* const> sources, const agent::PanoramaCode& goal) {
  std::vector<agent::PairPrediction> predictions;
  for (const agent::PanoramaCode* source : sources) {
    predictions.push_back(ComparePair(ToPose(*source), ToPose(goal)));
  }
  return predictions;
}

agent::PairPrediction OracleSemanticModel::ComparePair(const sim::BodyPose& source,
                                                       const sim::BodyPose& goal) {
  agent::PairPrediction prediction;
  if (IsInNode(*truth_.world, truth_.body, source, goal)) {
    const sim::PlanarPose place = sim::RelativePose(source, goal);
    prediction.same_node = 1.0f;
    prediction.distance = static_cast<float>(std::hypot(place.x, place.y));
    ShareDirection(sim::Atan2(place.y, place.x), &prediction.direction);
    return prediction;
  }
  const Eigen::Vector3f to = goal.position.cast<float>();
  for (int i = 0; i < kDirections; ++i) {
    const double left = query().GeodesicDistance(FarthestFree(source, i), to);
    const double score = std::max(0.0, 1.0 - left / agent::kFarthestScored);
    prediction.score[static_cast<std::size_t>(i)] = static_cast<float>(score);
  }
  return prediction;
}

Eigen::Vector3f OracleSemanticModel::FarthestFree(const sim::BodyPose& source, int direction) {
  for (double r = kNodeRadius; r > 0.5 * kSearchStep; r -= kSearchStep) {
    Eigen::Vector3f place = PlaceAt(source, direction, r);
    if (IsFree(source, place, r)) return place;
  }
  return source.position.cast<float>();
}

bool OracleSemanticModel::IsFree(const sim::BodyPose& source, const Eigen::Vector3f& place,
                                 double straight) {
  const auto floor = query().Snap(place);
  if (!floor || std::hypot(floor->x() - place.x(), floor->z() - place.z()) > kOffFloor) {
    return false;
  }
  const double way = query().GeodesicDistance(source.position.cast<float>(), *floor);
  return way < kDetour * straight;
}

const sim::NavmeshQuery& OracleSemanticModel::query() {
  if (world_ != truth_.world) {
    query_.reset();
    world_ = truth_.world;
    query_.emplace(world_->navmesh());
  }
  return *query_;
}

}  // namespace bulletnav::bench
