// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "agent/mapping/metric_map.h"
#include "benchmark/training/rl/exploration/viewshed.h"
#include "sim/math/rng.h"
#include "sim/navmesh/navmesh.h"
#include "sim/physics/capsule_body.h"
#include "sim/render/renderer.h"

namespace bulletnav::tests {

/// How much two maps of the same walk agree.
struct MapOverlap {
  double explored = 0.0;   // intersection over union of explored cells
  double obstacles = 0.0;  // share of both maps' obstacles that have one of the other within a cell
};

inline bool HasObstacleNear(const agent::MetricMap& map, const sim::Cell& cell) {
  for (int i = 0; i < 9; ++i) {
    const sim::Cell near{cell.x + i % 3 - 1, cell.y + i / 3 - 1};
    if (map.states().Contains(near) && map.IsObstacle(near)) return true;
  }
  return false;
}

/// Maps a scene from some random places, once by rendered depth and once by a simulated view.
inline MapOverlap CompareMaps(const sim::SceneMesh& mesh, double floor, int places,
                              std::uint64_t seed) {
  const sim::PhysicsWorld physics(mesh);
  const sim::Navmesh navmesh(mesh, {});
  const sim::NavmeshQuery query(navmesh);
  const auto scene = sim::MakeRenderScene(mesh, sim::Backend::kEmbree);
  const agent::Rig rig;
  const auto renderer = scene->MakeRenderer(rig.panorama);
  const bench::HeightColumns columns(mesh, floor);
  const agent::MapSpec spec;
  agent::MetricMap rendered(rig, spec);
  auto made = std::make_unique<bench::Viewshed>(spec, double{rig.camera_height});
  bench::Viewshed* view = made.get();
  agent::MetricMap simulated(spec, std::move(made), sim::PlanarPose{});
  bench::SeenGround seen;
  seen.cells.resize(columns.values().size());
  std::vector<std::uint8_t> color(3 * rig.panorama.pixels());
  std::vector<float> depth(rig.panorama.pixels());
  sim::CapsuleBody body(physics, {});
  sim::Rng rng(seed, "places");
  std::optional<sim::BodyPose> start;
  for (int i = 0; i < places;) {
    const Eigen::Vector3f at = query.RandomPoint(&rng, 0);
    const auto pose = body.TryReset({at.cast<double>(), rng.Uniform(-sim::kPi, sim::kPi)});
    if (!pose) continue;
    if (!start) start = pose;
    const sim::PlanarPose here = sim::RelativePose(*start, *pose);
    const Eigen::Vector3d eye = pose->position + Eigen::Vector3d(0, rig.camera_height, 0);
    const sim::CameraPose camera{eye.cast<float>(), static_cast<float>(pose->yaw)};
    renderer->Render({&camera, 1}, color, depth);
    rendered.Update({color, depth}, here);
    view->Place(&columns, *pose, &seen);
    simulated.Update({}, here);
    ++i;
  }
  int both_explored = 0, any_explored = 0, both_blocked = 0, any_blocked = 0;
  for (int y = 0; y < spec.cells(); ++y) {
    for (int x = 0; x < spec.cells(); ++x) {
      const sim::Cell cell{x, y};
      const bool a = rendered.IsExplored(cell), b = simulated.IsExplored(cell);
      both_explored += a && b ? 1 : 0;
      any_explored += a || b ? 1 : 0;
      const bool c = rendered.IsObstacle(cell), d = simulated.IsObstacle(cell);
      both_blocked += (c && HasObstacleNear(simulated, cell) ? 1 : 0) +
                      (d && HasObstacleNear(rendered, cell) ? 1 : 0);
      any_blocked += (c ? 1 : 0) + (d ? 1 : 0);
    }
  }
  const auto share = [](int a, int b) {
    return b == 0 ? 1.0 : static_cast<double>(a) / b;
  };
  return {share(both_explored, any_explored), share(both_blocked, any_blocked)};
}

}  // namespace bulletnav::tests
