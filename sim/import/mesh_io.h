// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <optional>
#include <set>
#include <span>
#include <string>

#include <assimp/DefaultIOSystem.h>

#include "sim/import/mesh_file_check.h"

namespace bulletnav::sim {

/// Processor time that reading a file of this size may take.
int SecondsToRead(const std::filesystem::path& file);

/// How assimp opens the files that a mesh consists of: only regular ones, for a pipe would be
/// waited for without end; names relative to the mesh may have percent codes; each file beside the
/// mesh's own gives the import more time, once.
class MeshIo final : public Assimp::DefaultIOSystem {
 public:
  /// `checked` is lent for the object's life.
  MeshIo(const std::filesystem::path& mesh, const CheckedMeshFile& checked)
      : mesh_(mesh.string()), checked_(checked), folder_(mesh.parent_path()), timed_{mesh_} {}

  bool Exists(const char* name) const override;
  Assimp::IOStream* Open(const char* name, const char* mode) override;

 private:
  std::optional<std::filesystem::path> Find(const std::string& name) const;
  /// What takes a file's place; empty if nothing does.
  std::span<const std::uint8_t> InPlaceOf(const std::string& name) const;

  std::string mesh_;
  const CheckedMeshFile& checked_;
  std::filesystem::path folder_;
  std::set<std::string> timed_;
};

}  // namespace bulletnav::sim
