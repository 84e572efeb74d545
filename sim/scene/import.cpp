// SPDX-License-Identifier: MIT
#include "sim/scene/import.h"

#include <cmath>
#include <set>
#include <string>

#include "sim/base/check.h"
#include "sim/base/error.h"
#include "sim/base/isolated.h"
#include "sim/scene/assimp_scene.h"
#include "sim/scene/clean.h"
#include "sim/scene/mesh_blob.h"
#include "sim/scene/mesh_file_check.h"
#include "sim/scene/mesh_io.h"
#include "sim/scene/texture_limit.h"
#include "sim/scene/up_axis.h"

namespace bulletnav::sim {
namespace {

constexpr int kImportSeconds = 10;
constexpr std::uint64_t kImportMemory = std::uint64_t{16} << 30;

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
}

/// Everything that believes in the file.
ImportedScene ReadScene(const std::filesystem::path& file, const ImportOptions& options,
                        const CheckedMeshFile& checked) {
  ImportedScene scene;
  ImportReport& report = scene.report;
  report.skipped = checked.ignored;
  scene.mesh = ReadWithAssimp(file, checked.content, &report);
  SceneMesh& mesh = scene.mesh;
  if (options.scale != 1.0) {
    for (Eigen::Vector3f& p : mesh.positions) p *= static_cast<float>(options.scale);
  }
  report.up_axis = options.up ? *options.up : DetectUpAxis(mesh, checked.usual_up);
  if (report.up_axis == UpAxis::kZ) TurnZUpToYUp(&mesh);
  CleanMesh(file, &mesh, &report);
  if (options.ground_plane) AddGroundPlane(&mesh);
  LimitTextures(&mesh);
  mesh.Validate();
  report.triangles = mesh.triangles.size();
  report.materials =
      std::set(mesh.triangle_materials.begin(), mesh.triangle_materials.end()).size();
  report.extent_m = mesh.Bounds().sizes();
  return scene;
}

}  // namespace

ImportedScene ImportScene(const std::filesystem::path& file, const ImportOptions& options) {
  if (!(options.scale > 0.0 && std::isfinite(options.scale))) {
    throw Error("the scale of a scene must be positive: metres per unit of the file");
  }
  const CheckedMeshFile checked = CheckMeshFile(file);
  // assimp crashes and hangs on some damaged files, and a library must not take its user with it.
  const IsolatedResult result = RunIsolated(
      [&] {
        return ToBlob(ReadScene(file, options, checked));
      },
      kImportSeconds + SecondsToRead(file), kImportMemory);
  switch (result.end) {
    case IsolatedResult::End::kDone:
      return FromBlob(result.bytes);
    case IsolatedResult::End::kThrew: {
      const std::string text(result.bytes.begin(), result.bytes.end());
      if (text.starts_with(file.string())) throw Error(text);
      throw FileError(file, "", "cannot be read: " + text);  // a library's, or the standard's
    }
    case IsolatedResult::End::kCrashed:
      throw FileError(file, "", "is damaged: reading it fails; export or download it again");
    case IsolatedResult::End::kTimedOut:
      throw FileError(file, "", "is damaged: reading it does not end; export it again");
    case IsolatedResult::End::kTooLarge:
      throw FileError(file, "", "asks for more memory than there is; is it damaged?");
  }
  CHECK(false);
}

}  // namespace bulletnav::sim
