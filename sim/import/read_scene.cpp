// SPDX-License-Identifier: MIT
#include "sim/import/read_scene.h"

#include <set>

#include "sim/base/error.h"
#include "sim/import/assimp_scene.h"
#include "sim/import/clean.h"
#include "sim/import/habitat_scene.h"
#include "sim/import/house_doors.h"
#include "sim/import/load_textures.h"
#include "sim/import/mesh_file_check.h"
#include "sim/import/scene_parts.h"
#include "sim/import/up_axis.h"

namespace bulletnav::sim {
namespace {

/// A level square under everything, 1 m wider than the mesh on each side.
void AddGroundPlane(SceneMesh* mesh) {
  const Eigen::AlignedBox3f box = mesh->Bounds();
  const Eigen::Vector3f low = box.min() - Eigen::Vector3f(1.0f, 0.0f, 1.0f);
  const Eigen::Vector3f high = box.max() + Eigen::Vector3f(1.0f, 0.0f, 1.0f);
  const auto base = static_cast<std::uint32_t>(mesh->positions.size());
  for (const float x : {low.x(), high.x()}) {
    for (const float z : {low.z(), high.z()}) {
      mesh->positions.emplace_back(x, low.y(), z);
      mesh->uvs.emplace_back(0.0f, 0.0f);
      mesh->colors.push_back(kWhite);
    }
  }
  const auto material = static_cast<std::uint32_t>(mesh->materials.size());
  mesh->materials.push_back({"ground plane", {150, 145, 140}, -1});
  mesh->triangles.push_back({base, base + 1, base + 2});
  mesh->triangles.push_back({base + 2, base + 1, base + 3});
  mesh->triangle_materials.insert(mesh->triangle_materials.end(), 2, material);
  if (!mesh->has_objects()) return;
  const auto object = static_cast<std::uint32_t>(mesh->objects.size());
  mesh->objects.push_back({"ground_plane", "ground_plane_1", ""});
  mesh->triangle_objects.insert(mesh->triangle_objects.end(), 2, object);
}

/// Turns, cleans and completes a mesh that has the file's axes and units.
void SetUp(const std::filesystem::path& file, const ImportOptions& options, UpAxis usual,
           bool is_known, ImportedScene* scene) {
  SceneMesh& mesh = scene->mesh;
  if (options.scale != 1.0) {
    for (Eigen::Vector3f& p : mesh.positions) p *= static_cast<float>(options.scale);
    for (DoorLeaf& door : scene->doors) door.hinge *= static_cast<float>(options.scale);
  }
  const UpAxis found = is_known || options.up ? usual : DetectUpAxis(mesh, usual);
  scene->report.up_axis = options.up.value_or(found);
  if (scene->report.up_axis == UpAxis::kZ) {
    TurnZUpToYUp(&mesh);
    for (DoorLeaf& door : scene->doors) {
      door.hinge = TurnedZUpToYUp(door.hinge);
      door.axis = TurnedZUpToYUp(door.axis);
    }
  }
  CleanMesh(file, &mesh, &scene->report);
  if (options.ground_plane) AddGroundPlane(&mesh);
}

[[noreturn]] void FailWithoutDoors(const std::filesystem::path& file) {
  throw FileError(file, "",
                  "no doors are known that could be turned, only those of generated houses with "
                  "their description (.json) beside them, of worlds whose doors have a revolute "
                  "joint called door, and articulated objects with an upright revolute joint; "
                  "leave out import.doors");
}

void FindHouseDoors(const std::filesystem::path& file, const ImportOptions& options,
                    ImportedScene* scene) {
  if (!options.doors) return;
  const auto doors = ReadHouseDoors(file);
  if (!doors && options.doors->turns()) FailWithoutDoors(file);
  scene->doors = doors.value_or(std::vector<DoorLeaf>{});
  RequireLeaves(file, scene->doors, scene->mesh);
}

void ReadMesh(const std::filesystem::path& file, const ImportOptions& options,
              ImportedScene* scene) {
  const CheckedMeshFile checked = CheckMeshFile(file);
  scene->report.skipped = checked.ignored;
  const AssimpScene source(file, checked);
  SceneMesh& mesh = scene->mesh;
  mesh = source.Convert(&scene->report);
  if (checked.objects.of_triangles.size() == mesh.triangles.size()) {
    mesh.objects = checked.objects.objects;
    mesh.triangle_objects = checked.objects.of_triangles;
  }
  FindHouseDoors(file, options, scene);
  SetUp(file, options, checked.usual_up, false, scene);
  LoadTextures(source, &mesh, &scene->report);
}

/// Completes the report.
void Measure(ImportedScene* scene) {
  const SceneMesh& mesh = scene->mesh;
  mesh.Validate();
  ImportReport& report = scene->report;
  report.triangles = mesh.triangles.size();
  report.materials =
      std::set(mesh.triangle_materials.begin(), mesh.triangle_materials.end()).size();
  report.extent_m = mesh.Bounds().sizes();
}

}  // namespace

ImportedScene ReadScene(const std::filesystem::path& file, const ImportOptions& options) {
  if (IsHabitatScene(file)) return ReadScene(file, ReadHabitatScene(file), options);
  ImportedScene scene;
  ReadMesh(file, options, &scene);
  Measure(&scene);
  return scene;
}

ImportedScene ReadScene(const std::filesystem::path& file, const SceneParts& parts,
                        const ImportOptions& options) {
  ImportedScene scene = JoinParts(file, parts);
  if (!options.doors) scene.doors.clear();
  if (options.doors && options.doors->turns() && scene.doors.empty()) FailWithoutDoors(file);
  SetUp(file, options, parts.up, true, &scene);
  Measure(&scene);
  return scene;
}

}  // namespace bulletnav::sim
