// SPDX-License-Identifier: MIT
#include "sim/import/mesh_file_check.h"

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sim/base/error.h"
#include "sim/base/files.h"
#include "sim/base/lower_case.h"
#include "sim/import/gltf_check.h"
#include "sim/import/ply_check.h"

namespace bulletnav::sim {
namespace {

/// Material libraries that an .obj names and that are not there: it is all grey without them.
std::vector<std::string> MissingLibraries(const std::filesystem::path& file,
                                          std::span<const std::uint8_t> bytes) {
  constexpr std::string_view kKey = "mtllib ";
  constexpr std::string_view kSpace = " \t\r";
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  std::vector<std::string> missing;
  for (std::size_t at = text.find(kKey); at != text.npos; at = text.find(kKey, at + 1)) {
    if (at != 0 && text[at - 1] != '\n') continue;
    std::string_view name = text.substr(at + kKey.size());
    name = name.substr(0, name.find('\n'));
    name.remove_prefix(std::min(name.find_first_not_of(kSpace), name.size()));
    name = name.substr(0, name.find_last_not_of(kSpace) + 1);
    std::error_code ignored;
    if (std::filesystem::exists(file.parent_path() / name, ignored)) continue;
    missing.push_back("material library " + std::string(name) + ", which is not beside the file");
  }
  return missing;
}

}  // namespace

bool IsGltfFile(const std::filesystem::path& file) {
  const std::string extension = LowerCase(file.extension().string());
  return extension == ".glb" || extension == ".gltf";
}

CheckedMeshFile CheckMeshFile(const std::filesystem::path& file) {
  const std::vector<std::uint8_t> bytes = ReadFile(file);
  const std::string extension = LowerCase(file.extension().string());
  constexpr std::array kKnown = {".glb", ".gltf", ".obj", ".ply", ".dae"};
  if (std::find(kKnown.begin(), kKnown.end(), extension) == kKnown.end()) {
    throw FileError(file, "",
                    "is not a .glb, .gltf, .obj, .ply or .dae mesh; scenes of several meshes are "
                    ".scene_instance.json, .sdf or .world");
  }
  if (bytes.empty()) throw FileError(file, "", "is empty; get or export it again");
  CheckedMeshFile checked;
  if (IsGltfFile(file)) CheckGltf(file, bytes, &checked);
  if (extension == ".ply") CheckPly(file, bytes);
  if (extension == ".obj") checked.ignored = MissingLibraries(file, bytes);
  // OBJ and PLY do not say; scans in PLY are mostly z-up. assimp turns COLLADA by its own element.
  checked.usual_up = extension == ".ply" ? UpAxis::kZ : UpAxis::kY;
  return checked;
}

}  // namespace bulletnav::sim
