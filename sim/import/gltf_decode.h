// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "sim/import/gltf_document.h"

namespace bulletnav::sim {

/// A glTF document without what assimp does not read.
struct DecodedGltf {  // NOLINT(bugprone-exception-escape): moving JSON throws nothing
  GltfDocument::Json json;
  std::vector<std::uint8_t> buffer;  // what `json` calls kDecodedBuffer; may be empty
  bool is_changed = false;
};

/// Of a document that has been checked: buffer views that were `decompressed`
/// (EXT_meshopt_compression) move into a buffer of their own; quantised positions and texture
/// coordinates (KHR_mesh_quantization) become floats; of several sets of coordinates, those that
/// the colour's texture names come first, turned and scaled as KHR_texture_transform says; pictures
/// in other formats (EXT_texture_webp, KHR_texture_basisu, ...) become the textures' own.
/// `views`: the bytes of all buffer views. Throws FileError for sparse quantised values.
/// Sources: the extensions' specifications; glTF 2.0, section 3.6.2.
DecodedGltf DecodeGltf(const GltfDocument& gltf, std::span<const GltfDocument::Bytes> views,
                       const std::vector<bool>& decompressed);

/// Whether an extension that a file requires is read, or changes nothing that is drawn: light does
/// not, materials' colours are all there is of them. Formats of pictures count as read: what is not
/// is told of each picture.
bool IsReadExtension(std::string_view name);

}  // namespace bulletnav::sim
