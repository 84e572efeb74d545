// SPDX-License-Identifier: MIT
#include "benchmark/training/supervised/sample_points.h"

#include <cmath>
#include <optional>

#include <fmt/core.h>

#include "sim/base/error.h"
#include "sim/math/rng.h"
#include "sim/physics/capsule_body.h"

namespace bulletnav::bench {
namespace {

constexpr int kTries = 2000;

}  // namespace

std::vector<sim::BodyPose> DrawPoints(const sim::World& world, const Storey& storey,
                                      const DataConfig& config) {
  const sim::NavmeshQuery query(world.navmesh());
  sim::CapsuleBody body(world.physics(), config.body);
  const auto draw = [&](sim::Rng rng) -> std::optional<sim::BodyPose> {
    for (int tried = 0; tried < kTries; ++tried) {
      const Eigen::Vector3d point = query.RandomPoint(&rng, storey.island).cast<double>();
      const double yaw = rng.Uniform(-sim::kPi, sim::kPi);
      if (std::abs(point.y() - storey.floor_y) > kSameStorey) continue;
      if (const auto pose = body.TryReset({point, yaw})) return pose;
    }
    return std::nullopt;
  };
  std::vector<sim::BodyPose> poses;
  for (int i = 0; i < config.points; ++i) {
    const auto pose = draw(sim::Rng({config.seed, world.id(), static_cast<std::uint64_t>(i)}));
    if (!pose) {
      throw sim::Error(
          fmt::format("scene {}: no place to stand found among {} points of its "
                      "walkable floor; leave the scene out",
                      world.name(), kTries));
    }
    poses.push_back(*pose);
  }
  return poses;
}

}  // namespace bulletnav::bench
