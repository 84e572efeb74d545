// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "benchmark/episodes/episode.h"
#include "sim/navmesh/navmesh.h"
#include "sim/physics/body_spec.h"
#include "sim/physics/physics_world.h"
#include "sim/scene/mesh.h"

namespace bulletnav::bench {

/// A scene to stand and walk in, without its looks: what episodes are drawn from and checked with.
/// SceneCache loads it.
struct Ground {
  Ground(std::string scene, const sim::SceneMesh& mesh, const sim::NavmeshSpec& spec)
      : name(std::move(scene)), physics(mesh), navmesh(mesh, spec, name) {}

  std::string name;  // the file's, as sim::World's
  sim::PhysicsWorld physics;
  sim::Navmesh navmesh;
};

/// Throws sim::Error, naming episode and remedy, unless the body can stand at the start and at each
/// goal and walk from each to the next.
void CheckEpisode(const Episode& episode, const sim::PhysicsWorld& physics,
                  const sim::Navmesh& navmesh, const sim::BodySpec& body);

}  // namespace bulletnav::bench
