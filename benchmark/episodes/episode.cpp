// SPDX-License-Identifier: MIT
#include "benchmark/episodes/episode.h"

#include <filesystem>

#include "benchmark/episodes/distance_bands.h"
#include "sim/base/elementary.h"
#include "sim/base/files.h"
#include "sim/math/rng.h"

namespace bulletnav::bench {

std::string_view DifficultyName(Difficulty difficulty) {
  switch (difficulty) {
    case Difficulty::kEasy:
      return "easy";
    case Difficulty::kMedium:
      return "medium";
    case Difficulty::kHard:
      return "hard";
    case Difficulty::kVeryHard:
      return "very_hard";
    case Difficulty::kExtreme:
      return "extreme";
  }
  return "";
}

std::optional<Difficulty> DifficultyNamed(std::string_view name) {
  for (const Difficulty difficulty : kDifficulties) {
    if (DifficultyName(difficulty) == name) return difficulty;
  }
  return std::nullopt;
}

std::optional<Difficulty> DifficultyAt(double geodesic_distance) {
  for (const Difficulty difficulty : kDifficulties) {
    if (BandOf(difficulty).Holds(geodesic_distance)) return difficulty;
  }
  return std::nullopt;
}

Rotation Rotation::FromYaw(double yaw) {
  return {0.0, sim::Sin(0.5 * yaw), 0.0, sim::Cos(0.5 * yaw)};
}

double Rotation::yaw() const {
  return sim::WrapAngle(2.0 * sim::Atan2(y, w));
}

bool EpisodeGoal::operator==(const EpisodeGoal& other) const {
  return position == other.position && rotation == other.rotation && radius == other.radius &&
         geodesic_distance == other.geodesic_distance;
}

sim::BodyPose Episode::start() const {
  return {start_position, start_rotation.yaw()};
}

sim::BodyPose Episode::goal(std::size_t i) const {
  const EpisodeGoal& goal = goals.at(i);
  if (goal.rotation) return {goal.position, goal.rotation->yaw()};
  // The scene's file name alone: the same episode in another folder looks the same way.
  const std::string name = std::filesystem::path(scene).filename().string();
  sim::Rng rng(sim::RngKey{i, sim::Hash64(name), sim::Hash64(id)});
  return {goal.position, rng.Uniform(-sim::kPi, sim::kPi)};
}

bool Episode::operator==(const Episode& other) const {
  return id == other.id && scene == other.scene && start_position == other.start_position &&
         start_rotation == other.start_rotation && goals == other.goals &&
         difficulty == other.difficulty && source == other.source;
}

}  // namespace bulletnav::bench
