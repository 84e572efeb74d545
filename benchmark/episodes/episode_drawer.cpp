// SPDX-License-Identifier: MIT
#include "benchmark/episodes/episode_drawer.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "sim/base/elementary.h"
#include "sim/base/error.h"
#include "sim/base/files.h"
#include "sim/math/rng.h"

namespace bulletnav::bench {
namespace {

constexpr float kLeastIslandRadius = 1.5f;
constexpr float kLeastIslandShare = 0.15f;  // of the largest: less is a bed or a table; ours
constexpr float kFloorAround = 1.0f;        // metres to where lower floor is looked for; ours
constexpr float kRaised = 0.12f;            // metres: more than a threshold
constexpr float kMostHeightDifference = 0.5f;
constexpr double kWindingRatio = 1.1;
constexpr double kGoalRadius = 1.0;  // within which an agent succeeds
constexpr double kSettled = 0.5;     // metres that standing up can move a body, at most
constexpr int kTriesAStart = 10;
constexpr int kTriesALeg = 300;  // of a sequence, on average
constexpr int kStarts = 4000;

Eigen::Vector3f Feet(const sim::BodyPose& pose) {
  return pose.position.cast<float>();
}

}  // namespace

double LeastRatio(double u) {
  return std::min(kWindingRatio, 0.98 + std::sqrt(u / 20.0));
}

EpisodeDrawer::EpisodeDrawer(const Ground& ground, std::string scene, std::string label,
                             const sim::BodySpec& body, std::uint64_t seed)
    : ground_(ground),
      scene_(std::move(scene)),
      label_(std::move(label)),
      seed_(seed),
      query_(ground.navmesh),
      body_(ground.physics, body) {
  double sum = 0.0;
  float largest = 0.0f;
  for (const sim::Island& island : ground.navmesh.islands()) {
    largest = std::max(largest, island.area);
  }
  for (const sim::Island& island : ground.navmesh.islands()) {
    const bool is_floor =
        island.radius >= kLeastIslandRadius && island.area >= kLeastIslandShare * largest;
    island_weights_.push_back(is_floor ? island.area : 0.0);
    sum += island_weights_.back();
  }
  if (sum > 0.0) return;
  throw sim::Error("scene " + scene_ +
                   ": no walkable island has a radius of 1.5 m; leave this scene out");
}

std::optional<EpisodeDrawer::Place> EpisodeDrawer::Stand(const Eigen::Vector3f& point, double yaw,
                                                         int island) {
  const auto pose = body_.TryReset({point.cast<double>(), yaw});
  if (!pose || IsRaised(pose->position.cast<float>())) return std::nullopt;
  return Place{*pose, island};
}

bool EpisodeDrawer::IsRaised(const Eigen::Vector3f& foot) const {
  constexpr int kPoints = 12;
  const Eigen::Vector3f up = Eigen::Vector3f::UnitY();
  for (int i = 0; i < kPoints; ++i) {
    const float angle = 2.0f * static_cast<float>(sim::kPi) * static_cast<float>(i) / kPoints;
    const Eigen::Vector3f beside =
        foot + kFloorAround * Eigen::Vector3f(sim::Cos(angle), 0.0f, sim::Sin(angle));
    constexpr float kDepth = kRaised + kMostHeightDifference;
    const Eigen::Vector3f top = beside + kRaised * up;
    const auto floor = ground_.physics.RayTest(top, top - kDepth * up);
    if (floor && floor->fraction * kDepth > 2.0f * kRaised) return true;
  }
  return false;
}

std::optional<EpisodeDrawer::Place> EpisodeDrawer::DrawStart(sim::Rng* rng) {
  const auto island = static_cast<int>(rng->Weighted(island_weights_));
  const Eigen::Vector3f point = query_.RandomPoint(rng, island);
  return Stand(point, rng->Uniform(-sim::kPi, sim::kPi), island);
}

std::optional<EpisodeDrawer::Place> EpisodeDrawer::DrawGoal(const Place& from,
                                                            const DistanceBand& band, sim::Rng* rng,
                                                            double* distance) {
  const double least_ratio = LeastRatio(rng->Uniform());
  const Eigen::Vector3f point = query_.RandomPoint(rng, from.island);
  const double yaw = rng->Uniform(-sim::kPi, sim::kPi);
  // A geodesic is never shorter than the straight line: most candidates need no search.
  const Eigen::Vector3f rough_gap = point - Feet(from.pose);
  if (rough_gap.norm() * least_ratio > band.high + kSettled) return std::nullopt;
  auto goal = Stand(point, yaw, from.island);
  if (!goal) return std::nullopt;
  const Eigen::Vector3d gap = goal->pose.position - from.pose.position;
  if (std::abs(gap.y()) > kMostHeightDifference) return std::nullopt;
  *distance = query_.GeodesicDistance(Feet(from.pose), Feet(goal->pose));
  if (!band.Holds(*distance) || *distance < least_ratio * gap.norm()) return std::nullopt;
  return goal;
}

std::vector<EpisodeGoal> EpisodeDrawer::DrawGoals(const Place& start, const DistanceBand& band,
                                                  int count, sim::Rng* rng) {
  std::vector<EpisodeGoal> goals;
  Place last = start;
  for (int tries = count == 1 ? kTriesAStart : count * kTriesALeg;
       tries > 0 && static_cast<int>(goals.size()) < count; --tries) {
    double distance = 0.0;
    const auto goal = DrawGoal(last, band, rng, &distance);
    if (!goal) continue;
    goals.push_back(
        {goal->pose.position, Rotation::FromYaw(goal->pose.yaw), kGoalRadius, distance});
    last = *goal;
  }
  return goals;
}

Episode EpisodeDrawer::Draw(std::string_view kind, int index, const DistanceBand& band, int goals) {
  const std::uint64_t number = sim::MixSeed(sim::Hash64(kind), static_cast<std::uint64_t>(index));
  sim::Rng rng(sim::RngKey{seed_, sim::Hash64(ground_.name), number});
  Episode episode;
  episode.id = fmt::format("{}-{}-{:04}", label_, kind, index);
  episode.scene = scene_;
  for (int tried = 0; tried < kStarts; ++tried) {
    const auto start = DrawStart(&rng);
    if (!start) continue;
    episode.goals = DrawGoals(*start, band, goals, &rng);
    if (static_cast<int>(episode.goals.size()) < goals) continue;
    episode.start_position = start->pose.position;
    episode.start_rotation = Rotation::FromYaw(start->pose.yaw);
    return episode;
  }
  throw sim::Error(fmt::format(
      "scene {}: no {} episode found among {} starts; its largest island has {:.1f} m2: leave the "
      "scene out or ask for nearer goals",
      scene_, kind, kStarts, ground_.navmesh.islands()[0].area));
}

Episode EpisodeDrawer::Draw(Difficulty difficulty, int index) {
  Episode episode = Draw(DifficultyName(difficulty), index, BandOf(difficulty), 1);
  episode.difficulty = difficulty;
  return episode;
}

Episode EpisodeDrawer::DrawSequence(int goals, int index) {
  return Draw("sequence", index, kSequentialBand, goals);
}

}  // namespace bulletnav::bench
