// SPDX-License-Identifier: MIT
#include "sim/render/renderer.h"

#include "sim/base/error.h"
#include "sim/render/cpu/cpu_scene.h"
#include "sim/render/egl_backend.h"

namespace bulletnav::sim {

void Renderer::RenderObjects(std::span<const CameraPose> cameras, std::span<std::uint8_t> color,
                             std::span<float> depth, std::span<std::int32_t> objects) {
  if (!sees_objects()) {
    throw RenderError(
        "this renderer cannot tell which objects it sees; take the backend embree, or EGL without "
        "a graphics processor");
  }
  Draw(cameras, {color, depth, objects, {}});
}

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
