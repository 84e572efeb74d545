// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <memory>
#include <string>

#include "sim/import/mesh_file_check.h"
#include "sim/scene/import.h"

struct aiScene;
namespace Assimp {  // NOLINT(readability-identifier-naming): assimp's own
class Importer;
}

namespace bulletnav::sim {

/// A mesh file as assimp reads it. Every file beside the mesh's own that is read adds to the time
/// allowed.
class AssimpScene {
 public:
  /// `checked`: of the same file, lent for the object's life. `keeps_axes`: COLLADA that says it is
  /// z up is not turned. Throws FileError.
  AssimpScene(const std::filesystem::path& file, const CheckedMeshFile& checked,
              bool keeps_axes = false);
  ~AssimpScene();
  AssimpScene(const AssimpScene&) = delete;
  AssimpScene& operator=(const AssimpScene&) = delete;
  AssimpScene(AssimpScene&&) = delete;
  AssimpScene& operator=(AssimpScene&&) = delete;

  /// The mesh in the file's own axes and units, not cleaned: indices are in range, coordinates may
  /// be anything. Textures have names and no pixels yet. Adds to the report's skipped lines. Throws
  /// FileError.
  SceneMesh Convert(ImportReport* report) const;

  /// Decodes one of its textures. Throws ImageError: not found, damaged, of no format that is read.
  Image LoadTexture(const std::string& name) const;

 private:
  std::filesystem::path file_;
  std::unique_ptr<Assimp::Importer> importer_;
  const aiScene* scene_ = nullptr;
};

}  // namespace bulletnav::sim
