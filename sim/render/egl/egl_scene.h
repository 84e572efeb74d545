// SPDX-License-Identifier: MIT
#pragma once
#include <memory>

#include "sim/render/egl/scene_buffers.h"
#include "sim/render/renderer.h"

namespace bulletnav::sim {

/// A scene for the rasteriser. Two passes: triangle ids into flat views around the camera, then for
/// each pixel its exact ray is met with the triangles seen there and shaded. So the picture is that
/// of the ray caster, on any OpenGL 4.5 driver, in hardware or software.
/// Throws RenderError if there is no such device or the scene does not fit on it.
std::unique_ptr<const RenderScene> MakeEglScene(const SceneMesh& mesh,
                                                GlDevice device = GlDevice::kAny,
                                                ResolveOn resolve = ResolveOn::kAuto);

}  // namespace bulletnav::sim
