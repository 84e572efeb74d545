// SPDX-License-Identifier: MIT
#include "benchmark/episodes/ground.h"

#include <cmath>

#include <fmt/core.h>

#include "sim/base/error.h"
#include "sim/physics/capsule_body.h"

namespace bulletnav::bench {

void CheckEpisode(const Episode& episode, const sim::PhysicsWorld& physics,
                  const sim::Navmesh& navmesh, const sim::BodySpec& spec) {
  const auto fail = [&](const std::string& place, const std::string& what) {
    throw sim::Error(
        fmt::format("episode '{}' in {}: {}: {}", episode.id, episode.scene, place, what));
  };
  sim::CapsuleBody body(physics, spec);
  const sim::NavmeshQuery query(navmesh);
  Eigen::Vector3f last = Eigen::Vector3f::Zero();
  const auto visit = [&](const std::string& place, const sim::BodyPose& pose, bool is_first) {
    try {
      body.Reset(pose);
    } catch (const sim::PoseError& e) {
      fail(place, e.what());
    }
    const Eigen::Vector3f at = pose.position.cast<float>();
    if (!is_first && !std::isfinite(query.GeodesicDistance(last, at))) {
      fail(place,
           "no way leads there, it is on another island; make the episode again, or check "
           "that the scene is the one it was made for");
    }
    last = at;
  };
  visit("start", episode.start(), true);
  for (std::size_t i = 0; i < episode.goals.size(); ++i) {
    visit(episode.goals.size() == 1 ? "goal" : fmt::format("goal {}", i + 1), episode.goal(i),
          false);
  }
}

}  // namespace bulletnav::bench
