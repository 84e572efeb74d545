// SPDX-License-Identifier: MIT
// Compiled once for each instruction set, with BULLETNAV_KERNELS naming the table to define and
// BULLETNAV_KERNELS_NAME what to call it; see CMakeLists.txt.
#include "sim/render/embree/kernels.h"

#include "sim/render/embree/shade_kernel.h"
#include "sim/render/embree/sweep_kernel.h"

namespace bulletnav::sim {
namespace {

void FindVisible(const KernelScene& scene, const KernelGrid& grid, const KernelFrame& frame,
                 const KernelScratch& scratch) {
  Sweep(scene, grid, frame, scratch).Run();
}

void Shade(const KernelScene& scene, const KernelGrid& grid, const KernelFrame& frame,
           const KernelScratch& scratch, std::uint8_t* color, float* depth) {
  Shader(scene, grid, frame, scratch).Run(color, depth);
}

}  // namespace

const Kernels BULLETNAV_KERNELS = {BULLETNAV_KERNELS_NAME, FindVisible, Shade};

}  // namespace bulletnav::sim
