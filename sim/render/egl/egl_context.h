// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <string>

#include <epoxy/egl.h>

namespace bulletnav::sim {

/// What kind of device may draw.
enum class GlDevice { kHardware, kAny };

/// A headless OpenGL 4.5 context: no display server, no surface. Contexts made with Share see the
/// same buffers and textures. A context is current in one thread at a time.
/// Throws RenderError, naming the remedy, if no device of the wanted kind has OpenGL 4.5.
class EglContext {
 public:
  explicit EglContext(GlDevice device);
  ~EglContext();
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;
  EglContext(EglContext&&) = delete;
  EglContext& operator=(EglContext&&) = delete;

  std::unique_ptr<EglContext> Share() const;

  /// While one lives, the context is the calling thread's. Released at the end, so that a renderer
  /// can be used and destroyed in any thread.
  class Current {
   public:
    /// Throws RenderError if the device is lost.
    explicit Current(const EglContext& context);
    ~Current();
    Current(const Current&) = delete;
    Current& operator=(const Current&) = delete;
    Current(Current&&) = delete;
    Current& operator=(Current&&) = delete;

   private:
    const EglContext& context_;
  };

  /// GL_RENDERER.
  const std::string& renderer() const { return renderer_; }
  /// Whether that is a graphics processor and not a driver in software.
  bool is_hardware() const;

 private:
  EglContext(EGLDisplay display, const EglContext& shared_with);
  bool Open(EGLDisplay display, EGLContext shared_with);
  bool MakeCurrent() const;
  void Release() const;
  void Close();

  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
  std::string renderer_;
};

}  // namespace bulletnav::sim
