// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sim/scene/doors.h"
#include "sim/scene/finish.h"
#include "sim/scene/mesh.h"

namespace bulletnav::sim {

enum class UpAxis { kY, kZ };

struct ImportOptions {
  /// Which axis of the file points up; found from the mesh's floors if not given.
  std::optional<UpAxis> up;
  /// Metres per unit of the file; positive.
  double scale = 1.0;
  /// Adds a floor at the lowest point of the mesh, for scenes that have none.
  bool ground_plane = false;
  /// How doors stand; not given: as in the file, and nobody asks where they are.
  std::optional<DoorSpec> doors = std::nullopt;
  /// How the scene looks, when it has been read.
  Finish finish = {};
};

/// What an import found and what it had to leave out.
struct ImportReport {
  std::size_t triangles = 0;
  std::size_t materials = 0;  // that triangles use
  std::size_t textures_found = 0;
  std::vector<std::string> textures_missing;  // "name: reason"
  Eigen::Vector3f extent_m = Eigen::Vector3f::Zero();
  UpAxis up_axis = UpAxis::kY;
  std::vector<std::string> skipped;  // one line a kind of thing, with its count
};

struct ImportedScene {
  SceneMesh mesh;
  ImportReport report;
  /// Those that can be turned, as they stand, where ImportOptions::doors is given.
  std::vector<DoorLeaf> doors = {};
  /// What is drawn, where it is not the mesh: with the damage of ImportOptions::finish.
  std::optional<SceneMesh> drawn = std::nullopt;

  const SceneMesh& drawn_mesh() const { return drawn ? *drawn : mesh; }
};

/// Loads an indoor scene: glb, gltf (quantised or meshoptimizer's, too), obj + mtl, ply (vertex
/// colours), dae, habitat-sim's scene_instance.json; turned y-up and cleaned (see CleanMesh),
/// textures no larger than can be seen (see LoadTextures). One that is missing or cannot be read is
/// drawn grey and named in the report. Doors can be turned in generated houses that have their
/// description (.json) beside them, and in worlds and articulated objects whose doors have a
/// revolute joint. Throws FileError, with place and remedy, for what is no scene: missing, empty,
/// damaged or cut off files, bad indices, no triangles, no building's size, or doors to be turned
/// where none are known.
ImportedScene ImportScene(const std::filesystem::path& file, const ImportOptions& options = {});

}  // namespace bulletnav::sim
