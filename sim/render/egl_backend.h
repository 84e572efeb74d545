// SPDX-License-Identifier: MIT
#pragma once
#include <memory>

#include "sim/render/renderer.h"

namespace bulletnav::sim {

/// Whether this machine has a graphics processor that EGL can use; never where the program was
/// built without EGL. Quick where it has none.
bool HasHardwareGpu();

/// A scene for EGL's devices, or for graphics processors alone. Throws RenderError if there is
/// none, or the program was built without EGL.
std::unique_ptr<const RenderScene> MakeEglRenderScene(const SceneMesh& mesh, bool on_hardware);

}  // namespace bulletnav::sim
