// SPDX-License-Identifier: MIT
#include "sim/render/renderer.h"

#include "sim/render/cpu/cpu_scene.h"
#include "sim/render/egl/egl_scene.h"

namespace bulletnav::sim {

std::unique_ptr<const RenderScene> MakeRenderScene(const SceneMesh& mesh, Backend backend) {
  switch (backend) {
    case Backend::kEgl:
      return MakeEglScene(mesh);
    case Backend::kEmbree:
      break;
    case Backend::kAuto:
      if (HasHardwareGpu()) return MakeEglScene(mesh, GlDevice::kHardware);
      break;
  }
  return MakeCpuScene(mesh);
}

}  // namespace bulletnav::sim
