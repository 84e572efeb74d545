// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "sim/render/renderer.h"
#include "sim/scene/mesh.h"

namespace bulletnav::tests {

/// The triangle that each pixel's ray meets first, by RayTracer, row by row; -1 where it meets
/// none. What renderers draw is held against it.
std::vector<std::int32_t> SeenTriangles(const sim::SceneMesh& mesh, const sim::CameraSpec& camera,
                                        const sim::CameraPose& pose);

}  // namespace bulletnav::tests
