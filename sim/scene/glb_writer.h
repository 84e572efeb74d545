// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <vector>

#include "sim/scene/mesh.h"

namespace bulletnav::sim {

/// The mesh as one binary glTF 2.0 file: a primitive a material, vertex colours as 16-bit linear
/// light, textures embedded as JPEG, materials unlit (KHR_materials_unlit), so that any viewer
/// shows what our renderers show. Objects, where they are known, are feature ids of the vertices
/// (EXT_mesh_features, attribute _FEATURE_ID_0: numbers in the list `objects` of the file's extras,
/// whose entries have category, name and room). ImportScene reads it back. The same mesh gives the
/// same bytes.
std::vector<std::uint8_t> EncodeGlb(const SceneMesh& mesh);

}  // namespace bulletnav::sim
