// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "sim/navmesh/navmesh.h"
#include "sim/physics/physics_world.h"
#include "sim/render/renderer.h"
#include "sim/scene/import.h"
#include "sim/sensors/sensor.h"

namespace bulletnav::sim {

struct WorldOptions {
  ImportOptions import;
  NavmeshSpec navmesh;
  Backend backend = Backend::kAuto;
};

/// Throws Error, offering the ground plane, if a scene has next to no floor to walk on: under 1 m2
/// or, where no island has 10 m2, a twentieth of its footprint (a few table tops are no floor).
/// `name` is the file's.
void RequireFloor(const std::string& name, const ImportReport& report, const Navmesh& navmesh);

/// One scene, ready to be moved in and looked at: physics, navmesh, renderer's data. Immutable
/// after loading, so that any number of simulators in any number of threads share it.
class World {
 public:
  /// Throws FileError if the file is no scene, RenderError if the backend cannot be had.
  static std::shared_ptr<const World> Load(const std::filesystem::path& file,
                                           const WorldOptions& options = {});
  /// From a mesh in memory, metres and y up: `options.import` is for files alone. `name` stands for
  /// it in random keys and messages. Throws Error for meshes that SceneMesh::Validate refuses.
  static std::shared_ptr<const World> FromMesh(const SceneMesh& mesh, const std::string& name,
                                               const WorldOptions& options = {});

  World(std::string name, const ImportedScene& scene, const WorldOptions& options);

  const std::string& name() const { return name_; }
  /// Stable number of the scene for random keys: a hash of its name. Load takes the file's name
  /// without folders, so files called alike in two folders have the same noise.
  std::uint64_t id() const { return id_; }
  const ImportReport& report() const { return report_; }
  const PhysicsWorld& physics() const { return physics_; }
  const Navmesh& navmesh() const { return navmesh_; }
  /// What the numbers of the channel `semantic` stand for; empty where nobody knows.
  const std::vector<SceneObject>& objects() const { return objects_; }
  /// Doors that can be turned, as they stand, where ImportOptions::doors is given.
  const std::vector<DoorLeaf>& doors() const { return doors_; }
  const RenderScene& render_scene() const { return *render_scene_; }
  /// What sensors are made for.
  SensorScene sensor_scene() const { return {*render_scene_, physics_, navmesh_}; }

  /// RequireFloor of this scene.
  void RequireFloor() const { bulletnav::sim::RequireFloor(name_, report_, navmesh_); }

 private:
  std::string name_;
  std::uint64_t id_;
  ImportReport report_;
  PhysicsWorld physics_;
  Navmesh navmesh_;
  std::vector<SceneObject> objects_;
  std::vector<DoorLeaf> doors_;
  std::unique_ptr<const RenderScene> render_scene_;
};

}  // namespace bulletnav::sim
