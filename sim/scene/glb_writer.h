// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <vector>

#include "sim/scene/mesh.h"

namespace bulletnav::sim {

/// The mesh as one binary glTF 2.0 file: a primitive a material, vertex colours as 16-bit linear
/// light, textures embedded as JPEG, materials unlit (KHR_materials_unlit), so that any viewer
/// shows what our renderers show. ImportScene reads it back. The same mesh gives the same bytes.
std::vector<std::uint8_t> EncodeGlb(const SceneMesh& mesh);

}  // namespace bulletnav::sim
