// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "sim/import/gltf_document.h"

namespace bulletnav::sim {

inline constexpr const char* kMeshopt = "EXT_meshopt_compression";

/// What a buffer view holds that is compressed as `packed`, its extension, says; `buffers` are the
/// bytes of the document's. Throws FileError at `place` for what cannot be decoded.
/// Source: the extension's specification; meshoptimizer decodes.
std::vector<std::uint8_t> DecodeMeshopt(const GltfDocument& gltf, const GltfDocument::Json& packed,
                                        std::span<const GltfDocument::Bytes> buffers,
                                        const std::string& place);

}  // namespace bulletnav::sim
