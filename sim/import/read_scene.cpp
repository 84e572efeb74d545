// SPDX-License-Identifier: MIT
#include "sim/import/read_scene.h"

#include <set>

#include "sim/import/assimp_scene.h"
#include "sim/import/clean.h"
#include "sim/import/load_textures.h"
#include "sim/import/mesh_file_check.h"
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

}  // namespace

ImportedScene ReadScene(const std::filesystem::path& file, const ImportOptions& options) {
  const CheckedMeshFile checked = CheckMeshFile(file);
  ImportedScene scene;
  ImportReport& report = scene.report;
  report.skipped = checked.ignored;
  const AssimpScene source(file, checked);
  scene.mesh = source.Convert(&report);
  SceneMesh& mesh = scene.mesh;
  if (checked.objects.of_triangles.size() == mesh.triangles.size()) {
    mesh.objects = checked.objects.objects;
    mesh.triangle_objects = checked.objects.of_triangles;
  }
  if (options.scale != 1.0) {
    for (Eigen::Vector3f& p : mesh.positions) p *= static_cast<float>(options.scale);
  }
  report.up_axis = options.up ? *options.up : DetectUpAxis(mesh, checked.usual_up);
  if (report.up_axis == UpAxis::kZ) TurnZUpToYUp(&mesh);
  CleanMesh(file, &mesh, &report);
  if (options.ground_plane) AddGroundPlane(&mesh);
  LoadTextures(source, &mesh, &report);
  mesh.Validate();
  report.triangles = mesh.triangles.size();
  report.materials =
      std::set(mesh.triangle_materials.begin(), mesh.triangle_materials.end()).size();
  report.extent_m = mesh.Bounds().sizes();
  return scene;
}

}  // namespace bulletnav::sim
