// SPDX-License-Identifier: MIT
#include "sim/render/egl/egl_context.h"

#include <array>
#include <cstdlib>
#include <filesystem>
#include <mutex>
#include <vector>

#include <epoxy/gl.h>

#include "sim/base/error.h"
#include "sim/render/egl_backend.h"

namespace bulletnav::sim {
namespace {

constexpr std::array<EGLint, 7> kContextAttributes = {EGL_CONTEXT_MAJOR_VERSION,
                                                      4,
                                                      EGL_CONTEXT_MINOR_VERSION,
                                                      5,
                                                      EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                                      EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                                      EGL_NONE};

/// Mesa's software driver starts raster threads of its own; one context a worker is faster. Mesa
/// reads the variable when the first screen is made.
void KeepSoftwareDriverSingleThreaded() {
  static std::once_flag once;
  std::call_once(once, [] {
    ::setenv("LP_NUM_THREADS", "0", /*overwrite=*/0);
  });
}

/// The displays worth trying: each device that EGL enumerates, then Mesa without a surface.
std::vector<EGLDisplay> Displays() {
  std::vector<EGLDisplay> displays;
  if (!epoxy_has_egl()) throw RenderError("there is no EGL library; install libegl1");
  if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_device_enumeration") &&
      epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_device")) {
    std::array<EGLDeviceEXT, 32> devices{};
    EGLint count = 0;
    if (eglQueryDevicesEXT(static_cast<EGLint>(devices.size()), devices.data(), &count)) {
      for (int i = 0; i < count; ++i) {
        displays.push_back(eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT,
                                                    devices[static_cast<std::size_t>(i)], nullptr));
      }
    }
  }
  if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) {
    displays.push_back(eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr));
  }
  return displays;
}

bool HasGraphicsDeviceNode() {
  namespace fs = std::filesystem;
  std::error_code ignored;
  for (const char* path : {"/dev/nvidiactl", "/dev/nvidia0", "/dev/dxg"}) {
    if (fs::exists(path, ignored)) return true;
  }
  for (const auto& entry : fs::directory_iterator("/dev/dri", ignored)) {
    if (entry.path().filename().string().starts_with("renderD")) return true;
  }
  return false;
}

}  // namespace

EglContext::EglContext(GlDevice device) {
  KeepSoftwareDriverSingleThreaded();
  for (const EGLDisplay display : Displays()) {
    if (display == EGL_NO_DISPLAY || !Open(display, EGL_NO_CONTEXT)) continue;
    if (is_hardware()) return;
    Close();
  }
  if (device == GlDevice::kHardware) throw RenderError("no graphics processor that EGL can use");
  for (const EGLDisplay display : Displays()) {
    if (display != EGL_NO_DISPLAY && Open(display, EGL_NO_CONTEXT)) return;
  }
  throw RenderError(
      "EGL offers no OpenGL 4.5 device; install libegl-mesa0 and libgl1-mesa-dri, or use the "
      "embree backend");
}

EglContext::EglContext(EGLDisplay display, const EglContext& shared_with) {
  if (!Open(display, shared_with.context_)) throw RenderError("EGL cannot make another context");
}

EglContext::~EglContext() {
  Close();
}

std::unique_ptr<EglContext> EglContext::Share() const {
  return std::unique_ptr<EglContext>(new EglContext(display_, *this));
}

bool EglContext::Open(EGLDisplay display, EGLContext shared_with) {
  EGLint major = 0;
  EGLint minor = 0;
  if (!eglInitialize(display, &major, &minor) || !eglBindAPI(EGL_OPENGL_API)) return false;
  display_ = display;
  context_ = eglCreateContext(display, EGL_NO_CONFIG_KHR, shared_with, kContextAttributes.data());
  if (context_ == EGL_NO_CONTEXT) return false;
  if (!MakeCurrent()) {
    Close();
    return false;
  }
  renderer_ = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  Release();
  return true;
}

void EglContext::Close() {
  if (context_ == EGL_NO_CONTEXT) return;
  eglDestroyContext(display_, context_);
  context_ = EGL_NO_CONTEXT;
  // The display is shared by all contexts of the process and lives as long as it does.
}

bool EglContext::MakeCurrent() const {
  // The API binding belongs to the thread.
  return eglBindAPI(EGL_OPENGL_API) &&
         eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_);
}

EglContext::Current::Current(const EglContext& context) : context_(context) {
  if (!context.MakeCurrent()) {
    throw RenderError("the OpenGL context is lost; restart the program");
  }
}

EglContext::Current::~Current() {
  context_.Release();
}

void EglContext::Release() const {
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
}

bool EglContext::is_hardware() const {
  for (const char* software : {"llvmpipe", "softpipe", "swrast", "SWR", "Software"}) {
    if (renderer_.find(software) != std::string::npos) return false;
  }
  return true;
}

bool HasHardwareGpu() {
  // Asking EGL takes half a second on machines without a GPU; the device files tell at once.
  if (!HasGraphicsDeviceNode()) return false;
  try {
    const EglContext context(GlDevice::kHardware);
    return true;
  } catch (const RenderError&) {
    return false;
  }
}

}  // namespace bulletnav::sim
