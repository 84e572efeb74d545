// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <span>

#include "sim/import/mesh_file_check.h"

namespace bulletnav::sim {

/// Checks the structure of a .glb or .gltf file and the buffers beside or in it: chunk and buffer
/// lengths, that every buffer view, accessor, image and index lies inside what it refers to, and
/// that the node graph is a forest. Throws FileError naming the first thing that is wrong and its
/// place. Source: the glTF 2.0 specification, sections 3 and 4.
/// Fills in the content, where assimp needs another (see GltfDocument::With and GltfDecoder), and
/// what is ignored.
void CheckGltf(const std::filesystem::path& file, std::span<const std::uint8_t> bytes,
               CheckedMeshFile* checked);

}  // namespace bulletnav::sim
