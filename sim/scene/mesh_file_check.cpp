// SPDX-License-Identifier: MIT
#include "sim/scene/mesh_file_check.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>

#include "sim/base/error.h"
#include "sim/base/files.h"
#include "sim/scene/gltf_check.h"
#include "sim/scene/ply_check.h"

namespace bulletnav::sim {
namespace {

std::string LowerExtension(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(), [](unsigned char c) {
    return static_cast<char>(std::tolower(c));
  });
  return extension;
}

}  // namespace

bool IsGltfFile(const std::filesystem::path& file) {
  const std::string extension = LowerExtension(file);
  return extension == ".glb" || extension == ".gltf";
}

CheckedMeshFile CheckMeshFile(const std::filesystem::path& file) {
  const std::vector<std::uint8_t> bytes = ReadFile(file);
  const std::string extension = LowerExtension(file);
  constexpr std::array kKnown = {".glb", ".gltf", ".obj", ".ply", ".dae"};
  if (std::find(kKnown.begin(), kKnown.end(), extension) == kKnown.end()) {
    throw FileError(file, "", "is not a .glb, .gltf, .obj, .ply or .dae mesh");
  }
  if (bytes.empty()) throw FileError(file, "", "is empty");
  CheckedMeshFile checked;
  if (IsGltfFile(file)) CheckGltf(file, bytes, &checked);
  if (extension == ".ply") CheckPly(file, bytes);
  // OBJ and PLY do not say; scans in PLY are mostly z-up. assimp turns COLLADA by its own element.
  checked.usual_up = extension == ".ply" ? UpAxis::kZ : UpAxis::kY;
  return checked;
}

}  // namespace bulletnav::sim
