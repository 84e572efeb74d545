// SPDX-License-Identifier: MIT
#include "sim/render/panorama_renderer.h"

#include "sim/base/error.h"
#include "sim/render/cpu/cpu_scene.h"
#ifdef BULLETNAV_EGL
#include "sim/render/egl/egl_scene.h"
#endif

namespace bulletnav::sim {
namespace {

#ifdef BULLETNAV_EGL
/// Null if there is none.
std::unique_ptr<const RenderScene> MakeGpuScene(const SceneMesh& mesh) {
  return HasHardwareGpu() ? MakeEglScene(mesh, GlDevice::kHardware) : nullptr;
}
#else
std::unique_ptr<const RenderScene> MakeGpuScene(const SceneMesh& /*mesh*/) {
  return nullptr;
}
std::unique_ptr<const RenderScene> MakeEglScene(const SceneMesh& /*mesh*/) {
  throw RenderError("the backend egl is not there: built without EGL (BULLETNAV_EGL)");
}
#endif

}  // namespace

std::unique_ptr<const RenderScene> MakeRenderScene(const SceneMesh& mesh, Backend backend) {
  switch (backend) {
    case Backend::kEgl:
      return MakeEglScene(mesh);
    case Backend::kEmbree:
      break;
    case Backend::kAuto:
      if (auto scene = MakeGpuScene(mesh)) return scene;
      break;
  }
  return MakeCpuScene(mesh);
}

}  // namespace bulletnav::sim
