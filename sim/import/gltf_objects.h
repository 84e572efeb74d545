// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "sim/import/gltf_document.h"
#include "sim/import/mesh_file_check.h"

namespace bulletnav::sim {

/// The objects of a file as EncodeGlb writes them: a list `objects` among the document's extras and
/// feature ids (EXT_mesh_features, attribute _FEATURE_ID_0) of the vertices of the one mesh that it
/// has. Nothing where a file has none, more meshes, or ids of another make: those are not read.
/// `views`: the content of each buffer view. Expects: a document that GltfChecker let pass. Throws
/// FileError for ids of no object.
FileObjects ReadGltfObjects(const GltfDocument& gltf, std::span<const GltfDocument::Bytes> views);

}  // namespace bulletnav::sim
