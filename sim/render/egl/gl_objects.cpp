// SPDX-License-Identifier: MIT
#include "sim/render/egl/gl_objects.h"

#include <string>
#include <vector>

#include "sim/base/check.h"
#include "sim/base/error.h"

namespace bulletnav::sim {
namespace {

void Attach(GLuint program, GLenum stage, std::string_view source) {
  const GLuint shader = glCreateShader(stage);
  const char* text = source.data();
  const auto length = static_cast<GLint>(source.size());
  glShaderSource(shader, 1, &text, &length);
  glCompileShader(shader);
  GLint done = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &done);
  if (done != GL_TRUE) {
    std::string log(4096, '\0');
    glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
    internal::CheckFailed(__FILE__, __LINE__, "shader compiles", "\n" + log);
  }
  glAttachShader(program, shader);
  glDeleteShader(shader);  // the program keeps it
}

GlProgram Link(GLuint program) {
  glLinkProgram(program);
  GLint done = GL_FALSE;
  glGetProgramiv(program, GL_LINK_STATUS, &done);
  BULLETNAV_CHECK_EQ(done, GL_TRUE);
  return GlProgram(program);
}

GlBuffer Store(std::size_t bytes, const void* content, GLbitfield flags) {
  GLuint name = 0;
  glCreateBuffers(1, &name);
  GlBuffer buffer(name);
  glNamedBufferStorage(name, static_cast<GLsizeiptr>(std::max<std::size_t>(bytes, 16)), nullptr,
                       flags | GL_DYNAMIC_STORAGE_BIT);
  if (glGetError() == GL_OUT_OF_MEMORY) throw RenderError("the scene does not fit on the GPU");
  if (content != nullptr && bytes > 0) {
    glNamedBufferSubData(name, 0, static_cast<GLsizeiptr>(bytes), content);
  }
  return buffer;
}

}  // namespace

GlBuffer NewBuffer(std::span<const std::byte> content) {
  return Store(content.size(), content.data(), 0);
}

GlBuffer NewReadBuffer(std::size_t bytes) {
  return Store(bytes, nullptr, GL_MAP_READ_BIT);
}

GlTexture NewTarget(GLenum format, int width, int height, int layers) {
  GLuint name = 0;
  glCreateTextures(layers > 0 ? GL_TEXTURE_2D_ARRAY : GL_TEXTURE_2D, 1, &name);
  GlTexture texture(name);
  if (layers > 0) {
    glTextureStorage3D(name, 1, format, width, height, layers);
  } else {
    glTextureStorage2D(name, 1, format, width, height);
  }
  glTextureParameteri(name, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTextureParameteri(name, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  return texture;
}

GlProgram NewRasterProgram(std::string_view vertex, std::string_view fragment) {
  const GLuint program = glCreateProgram();
  Attach(program, GL_VERTEX_SHADER, vertex);
  Attach(program, GL_FRAGMENT_SHADER, fragment);
  return Link(program);
}

GlProgram NewComputeProgram(std::string_view compute) {
  const GLuint program = glCreateProgram();
  Attach(program, GL_COMPUTE_SHADER, compute);
  return Link(program);
}

}  // namespace bulletnav::sim
