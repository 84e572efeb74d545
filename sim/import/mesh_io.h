// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <optional>
#include <set>
#include <span>
#include <string>

#include <assimp/DefaultIOSystem.h>

namespace bulletnav::sim {

/// Processor time that reading a file of this size may take.
int SecondsToRead(const std::filesystem::path& file);

/// How assimp opens the files that a mesh consists of: only regular ones, for a pipe would be
/// waited for without end; names relative to the mesh may have percent codes; each file beside the
/// mesh's own gives the import more time, once.
class MeshIo final : public Assimp::DefaultIOSystem {
 public:
  /// `content`, unless empty, takes the place of what `mesh` holds; lent for the object's life.
  MeshIo(const std::filesystem::path& mesh, std::span<const std::uint8_t> content)
      : mesh_(mesh.string()), content_(content), folder_(mesh.parent_path()), timed_{mesh_} {}

  bool Exists(const char* name) const override;
  Assimp::IOStream* Open(const char* name, const char* mode) override;

 private:
  std::optional<std::filesystem::path> Find(const std::string& name) const;

  std::string mesh_;
  std::span<const std::uint8_t> content_;
  std::filesystem::path folder_;
  std::set<std::string> timed_;
};

}  // namespace bulletnav::sim
