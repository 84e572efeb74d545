// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <vector>

#include "sim/render/embree/kernels.h"
#include "sim/render/panorama_renderer.h"

namespace bulletnav::sim {

/// The kernels this processor can run, the fastest first.
std::vector<const Kernels*> SupportedKernels();

/// A scene for the CPU renderer: Embree builds the hierarchy, the kernels walk it. All kernels draw
/// the same bits; the choice is for tests.
std::unique_ptr<const RenderScene> MakeEmbreeScene(
    const SceneMesh& mesh, const Kernels& kernels = *SupportedKernels().front());

}  // namespace bulletnav::sim
