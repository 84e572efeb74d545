// SPDX-License-Identifier: MIT
#pragma once
#include <memory>

#include "sim/render/kernels/kernels.h"
#include "sim/render/renderer.h"

namespace bulletnav::sim {

/// A scene for the CPU renderer: Embree builds the hierarchy, the kernels walk it. All kernels draw
/// the same bits; the choice is for tests.
std::unique_ptr<const RenderScene> MakeCpuScene(const SceneMesh& mesh,
                                                const Kernels& kernels = *SupportedKernels()[0]);

}  // namespace bulletnav::sim
