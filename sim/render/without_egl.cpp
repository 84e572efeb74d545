// SPDX-License-Identifier: MIT
// In the place of egl/ where the program is built without it.
#include "sim/base/error.h"
#include "sim/render/egl_backend.h"

namespace bulletnav::sim {

bool HasHardwareGpu() {
  return false;
}

std::unique_ptr<const RenderScene> MakeEglRenderScene(const SceneMesh& /*mesh*/,
                                                      bool /*on_hardware*/) {
  throw RenderError("this program was built without EGL; use the backend embree");
}

}  // namespace bulletnav::sim
