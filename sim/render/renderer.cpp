// SPDX-License-Identifier: MIT
#include "sim/render/renderer.h"

#include "sim/render/cpu/cpu_scene.h"
#include "sim/render/egl_backend.h"

namespace bulletnav::sim {

std::unique_ptr<const RenderScene> MakeRenderScene(const SceneMesh& mesh, Backend backend) {
  switch (backend) {
    case Backend::kEgl:
      return MakeEglRenderScene(mesh, /*on_hardware=*/false);
    case Backend::kEmbree:
      break;
    case Backend::kAuto:
      if (HasHardwareGpu()) return MakeEglRenderScene(mesh, /*on_hardware=*/true);
      break;
  }
  return MakeCpuScene(mesh);
}

}  // namespace bulletnav::sim
