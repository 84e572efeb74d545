// SPDX-License-Identifier: MIT
#include "benchmark/training/rl/exploration/exploration_scenes.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "sim/base/error.h"
#include "sim/math/rng.h"
#include "sim/physics/capsule_body.h"
#include "sim/threads/worker_pool.h"

namespace bulletnav::bench {
namespace {

constexpr int kTries = 200;
constexpr int kPlaces = 33;          // from which the floor's height is found
constexpr double kSameFloor = 0.15;  // metres

std::optional<sim::BodyPose> DrawPlace(const Ground& ground, sim::CapsuleBody* body,
                                       sim::Rng* rng) {
  const sim::NavmeshQuery query(ground.navmesh);
  const Eigen::Vector3f point = query.RandomPoint(rng, 0);
  return body->TryReset({point.cast<double>(), rng->Uniform(-sim::kPi, sim::kPi)});
}

/// The middle one of the heights at which a body stands; absent if it stands nowhere.
std::optional<double> HeightOfFloor(const Ground& ground) {
  if (ground.navmesh.islands().empty()) return std::nullopt;
  sim::CapsuleBody body(ground.physics, {});
  sim::Rng rng(0, "floor");
  std::vector<double> heights;
  for (int i = 0; i < kTries && heights.size() < kPlaces; ++i) {
    if (const auto place = DrawPlace(ground, &body, &rng)) heights.push_back(place->position.y());
  }
  if (heights.empty()) return std::nullopt;
  const auto middle = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 2);
  std::nth_element(heights.begin(), middle, heights.end());
  return *middle;
}

}  // namespace

ExplorationScene LoadForExploration(const std::filesystem::path& file,
                                    const sim::ImportOptions& options) {
  const sim::ImportedScene imported = sim::ImportScene(file, options);
  ExplorationScene scene;
  scene.ground =
      std::make_unique<const Ground>(file.filename().string(), imported.mesh, sim::NavmeshSpec{});
  const std::optional<double> floor = HeightOfFloor(*scene.ground);
  if (!floor) throw sim::FileError(file, "", "has no floor on which a body can stand");
  scene.floor = *floor;
  scene.columns = std::make_unique<const HeightColumns>(imported.mesh, *floor);
  return scene;
}

ExplorationScenes::ExplorationScenes(const std::vector<std::filesystem::path>& files,
                                     const sim::ImportOptions& options, std::uint64_t seed,
                                     int threads, const std::function<void()>& loaded)
    : seed_(seed), scenes_(files.size()) {
  sim::WorkerPool pool(threads);
  pool.ForEach(static_cast<int>(files.size()), [&](int i, int) {
    const auto at = static_cast<std::size_t>(i);
    scenes_[at] = LoadForExploration(files[at], options);
    if (loaded) loaded();
  });
}

ExplorationScenes::Drawn ExplorationScenes::DrawIn(const ExplorationScene& scene,
                                                   sim::Rng rng) const {
  sim::CapsuleBody body(scene.ground->physics, {});
  for (int i = 0; i < kTries; ++i) {
    const auto place = DrawPlace(*scene.ground, &body, &rng);
    if (!place || std::fabs(place->position.y() - scene.floor) > kSameFloor) continue;
    const std::uint64_t high = rng.Next();
    return {&scene, *place, (high << 32) | rng.Next()};
  }
  throw sim::Error(scene.ground->name + " has hardly a place to start from");
}

ExplorationScenes::Drawn ExplorationScenes::Draw(int lane, std::uint64_t number) const {
  sim::Rng rng = sim::Rng(seed_, "exploration")
                     .Fork("lane", static_cast<std::uint64_t>(lane))
                     .Fork("episode", number);
  const ExplorationScene& scene =
      scenes_[static_cast<std::size_t>(rng.Below(static_cast<int>(scenes_.size())))];
  return DrawIn(scene, rng.Fork("start"));
}

ExplorationScenes::Drawn ExplorationScenes::DrawInTurn(std::uint64_t number) const {
  return DrawIn(scenes_[number % scenes_.size()],
                sim::Rng(seed_, "exploration_in_turn").Fork("episode", number));
}

}  // namespace bulletnav::bench
