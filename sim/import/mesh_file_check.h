// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "sim/scene/import.h"

namespace bulletnav::sim {

/// How deeply nodes may be nested, and what is said of more.
inline constexpr int kMaxNodeDepth = 256;
inline constexpr const char* kTooDeep =
    "nested more than 256 deep; flatten the hierarchy and export it again";

/// By extension, in any letter case.
bool IsGltfFile(const std::filesystem::path& file);

/// What the triangles of a file belong to; see SceneMesh.
struct FileObjects {
  std::vector<SceneObject> objects;
  std::vector<std::uint32_t> of_triangles;  // in the order in which the file has them
};
/// A file that is not there: a buffer of glTF with what has been decoded of others.
inline constexpr const char* kDecodedBuffer = "bulletnav-decoded.bin";

struct CheckedMeshFile {
  /// Which axis is up in that format by convention.
  UpAxis usual_up = UpAxis::kY;
  /// To be read in place of the file's content, if not empty.
  std::vector<std::uint8_t> content;
  /// What `content` calls kDecodedBuffer.
  std::vector<std::uint8_t> decoded;
  /// What the scene is read without, one line a kind of thing, with its count.
  std::vector<std::string> ignored;
  /// Empty where the file does not say.
  FileObjects objects;
};

/// Looks at a mesh file before assimp does, because a damaged file should end in a sentence: format
/// by extension, sizes, and for glTF every length and index in it.
/// Throws FileError.
CheckedMeshFile CheckMeshFile(const std::filesystem::path& file);

}  // namespace bulletnav::sim
