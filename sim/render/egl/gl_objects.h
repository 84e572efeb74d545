// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <string_view>
#include <utility>

#include <epoxy/gl.h>

namespace bulletnav::sim {

/// OpenGL names that delete themselves. Made and destroyed while a context of their share group is
/// current. Movable, so that they can be members set after construction.
template <class Deleter>
class GlName {
 public:
  GlName() = default;
  explicit GlName(GLuint name) : name_(name) {}
  ~GlName() { Reset(); }
  GlName(GlName&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  GlName& operator=(GlName&& other) noexcept {
    if (this != &other) {
      Reset();
      name_ = std::exchange(other.name_, 0);
    }
    return *this;
  }
  GlName(const GlName&) = delete;
  GlName& operator=(const GlName&) = delete;

  GLuint get() const { return name_; }

 private:
  void Reset() {
    if (name_ != 0) Deleter()(name_);
    name_ = 0;
  }
  GLuint name_ = 0;
};

struct DeleteBuffer {
  void operator()(GLuint name) const { glDeleteBuffers(1, &name); }
};
struct DeleteTexture {
  void operator()(GLuint name) const { glDeleteTextures(1, &name); }
};
struct DeleteFramebuffer {
  void operator()(GLuint name) const { glDeleteFramebuffers(1, &name); }
};
struct DeleteVertexArray {
  void operator()(GLuint name) const { glDeleteVertexArrays(1, &name); }
};
struct DeleteProgram {
  void operator()(GLuint name) const { glDeleteProgram(name); }
};

using GlBuffer = GlName<DeleteBuffer>;
using GlTexture = GlName<DeleteTexture>;
using GlFramebuffer = GlName<DeleteFramebuffer>;
using GlVertexArray = GlName<DeleteVertexArray>;
using GlProgram = GlName<DeleteProgram>;

/// An immutable buffer with this content, or empty and readable by the CPU.
GlBuffer NewBuffer(std::span<const std::byte> content);
GlBuffer NewReadBuffer(std::size_t bytes);
/// A texture without pyramid levels that can be rendered to; of several layers if `layers` > 0.
GlTexture NewTarget(GLenum format, int width, int height, int layers = 0);
/// Compile and link; a failure is our bug and ends the program with the driver's log.
GlProgram NewRasterProgram(std::string_view vertex, std::string_view fragment);
GlProgram NewComputeProgram(std::string_view compute);

}  // namespace bulletnav::sim
