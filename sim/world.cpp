// SPDX-License-Identifier: MIT
#include "sim/world.h"

#include <fmt/core.h>

#include "sim/base/error.h"
#include "sim/base/files.h"

namespace bulletnav::sim {
namespace {

constexpr float kLeastFloor = 1.0f;  // m2

}  // namespace

World::World(std::string name, const ImportedScene& scene, const WorldOptions& options)
    : name_(std::move(name)),
      id_(Hash64(name_)),
      report_(scene.report),
      physics_(scene.mesh),
      navmesh_(scene.mesh, options.navmesh),
      render_scene_(MakeRenderScene(scene.mesh, options.backend)) {}

std::shared_ptr<const World> World::Load(const std::filesystem::path& file,
                                         const WorldOptions& options) {
  return std::make_shared<const World>(file.filename().string(), ImportScene(file, options.import),
                                       options);
}

std::shared_ptr<const World> World::FromMesh(const SceneMesh& mesh, const std::string& name,
                                             const WorldOptions& options) {
  ImportedScene scene;
  scene.mesh = mesh;
  scene.report.triangles = mesh.triangles.size();
  scene.report.extent_m = mesh.Bounds().sizes();
  return std::make_shared<const World>(name, scene, options);
}

void World::RequireFloor() const {
  if (navmesh_.area() >= kLeastFloor) return;
  throw Error(fmt::format("{}: has {:.2f} m2 of floor to walk on; if the scene was made without a "
                          "floor, give --ground-plane, if it lies on its side, --up",
                          name_, navmesh_.area()));
}

}  // namespace bulletnav::sim
