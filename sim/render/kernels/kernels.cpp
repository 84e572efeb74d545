// SPDX-License-Identifier: MIT
// Compiled once for each instruction set, with BULLETNAV_KERNELS naming the table to define and
// BULLETNAV_KERNELS_NAME what to call it; see CMakeLists.txt.
#include "sim/render/kernels/kernels.h"

#include "sim/render/kernels/resolve.h"
#include "sim/render/kernels/shade.h"
#include "sim/render/kernels/sweep.h"
#include "sim/render/kernels/trace.h"

namespace bulletnav::sim {
namespace {

void FindVisible(const KernelScene& scene, const KernelGrid& grid, const KernelFrame& frame,
                 const KernelScratch& scratch, const KernelHits& hits) {
  Sweep(scene, grid, frame, scratch, hits).Run();
}

void Resolve(const KernelScene& scene, const KernelGrid& grid, const KernelFrame& frame,
             const KernelIdPicture& picture, const KernelHits& hits) {
  Resolver(scene, grid, frame, picture, hits).Run();
}

void Shade(const KernelScene& scene, const KernelGrid& grid, const KernelFrame& frame,
           const KernelHits& hits, std::uint8_t* color, float* depth) {
  Shader(scene, grid, frame, hits).Run(color, depth);
}

void Trace(const KernelScene& scene, const KernelRay* rays, int count, bool any, KernelHit* hits) {
  for (int i = 0; i < count; ++i) hits[i] = Tracer(scene, rays[i]).Run(any);
}

}  // namespace

const Kernels BULLETNAV_KERNELS = {BULLETNAV_KERNELS_NAME, FindVisible, Resolve, Shade, Trace};

}  // namespace bulletnav::sim
