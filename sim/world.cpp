// SPDX-License-Identifier: MIT
#include "sim/world.h"

#include <algorithm>
#include <set>

#include <fmt/core.h>

#include "sim/base/error.h"
#include "sim/base/files.h"

namespace bulletnav::sim {
namespace {

constexpr float kLeastFloor = 1.0f;    // m2
constexpr float kLeastShare = 0.05f;   // of the footprint
constexpr float kLargeIsland = 10.0f;  // m2

}  // namespace

World::World(std::string name, const ImportedScene& scene, const WorldOptions& options)
    : name_(std::move(name)),
      id_(Hash64(name_)),
      report_(scene.report),
      physics_(scene.mesh),
      navmesh_(scene.mesh, options.navmesh, name_),
      objects_(scene.drawn_mesh().objects),
      doors_(scene.doors),
      render_scene_(MakeRenderScene(scene.drawn_mesh(), options.backend)) {}

std::shared_ptr<const World> World::Load(const std::filesystem::path& file,
                                         const WorldOptions& options) {
  return std::make_shared<const World>(file.filename().string(), ImportScene(file, options.import),
                                       options);
}

std::shared_ptr<const World> World::FromMesh(const SceneMesh& mesh, const std::string& name,
                                             const WorldOptions& options) {
  mesh.Validate();
  ImportedScene scene;
  scene.mesh = mesh;
  scene.report.triangles = mesh.triangles.size();
  scene.report.materials =
      std::set(mesh.triangle_materials.begin(), mesh.triangle_materials.end()).size();
  scene.report.extent_m = mesh.Bounds().sizes();
  return std::make_shared<const World>(name, scene, options);
}

void RequireFloor(const std::string& name, const ImportReport& report, const Navmesh& navmesh) {
  const float footprint = report.extent_m.x() * report.extent_m.z();
  if (navmesh.area() >= std::max(kLeastFloor, kLeastShare * footprint)) return;
  if (!navmesh.islands().empty() && navmesh.islands()[0].area >= kLargeIsland) return;
  throw Error(
      fmt::format("{}: has {:.1f} m2 to walk on in a footprint of {:.0f} m2; if it was made "
                  "without a floor, give --ground-plane (in a config: ground_plane: true in the "
                  "block 'import', of trainings in their block 'data'), if it lies on its side, "
                  "--up (up: z)",
                  name, navmesh.area(), footprint));
}

}  // namespace bulletnav::sim
