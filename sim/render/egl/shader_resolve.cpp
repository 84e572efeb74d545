// SPDX-License-Identifier: MIT
#include "sim/render/egl/shader_resolve.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "sim/base/elementary.h"
#include "sim/base/error.h"
#include "sim/render/egl/shaders.h"

namespace bulletnav::sim {
namespace {

constexpr int kGroupSize = 64;  // of the shader
constexpr std::size_t kBytesAPixel = 3 + sizeof(float);

/// Binding points of the shader.
enum Binding : GLuint { kCorners, kShading, kTexels, kTextures, kRays, kViews, kCameras, kOutput };

/// Structs as the shader reads them.
struct ViewBlock {
  float right[4];
  float up[4];
  float forward[4];
  std::int32_t place[4];
};

struct CameraBlock {
  float origin[4];
  float turn[4];
};

template <class T>
GlBuffer Upload(const std::vector<T>& values) {
  return NewBuffer(std::as_bytes(std::span(values)));
}

// The shader's depth is below zero on glass.
void CopySizes(std::span<const float> depth, float* out) {
  std::transform(depth.begin(), depth.end(), out, [](float d) {
    return std::abs(d);
  });
}

void CopySigns(std::span<const float> depth, std::uint8_t* out) {
  std::transform(depth.begin(), depth.end(), out, [](float d) {
    return static_cast<std::uint8_t>(d < 0.0f ? 1 : 0);
  });
}

}  // namespace

ShaderResolve::ShaderResolve(const SceneBuffers& scene, const ViewLayout& layout,
                             const CameraSpec& spec, int batch)
    : scene_(scene),
      layout_(layout),
      size_(SizeOf(spec)),
      max_depth_(MaxDepthOf(spec)),
      padded_pixels_((size_.pixels() + 3) / 4 * 4) {
  program_ = NewComputeProgram(kResolveShader);
  UploadRays(RayGrid(spec));
  UploadViews();
  const auto n = static_cast<std::size_t>(batch);
  cameras_ = Upload(std::vector<CameraBlock>(n));
  output_ = NewReadBuffer(padded_pixels_ * kBytesAPixel * n);
}

void ShaderResolve::UploadRays(const RayGrid& grid) {
  pitch_ = grid.pitch;
  std::vector<float> rays;
  for (const auto* part : {&grid.y, &grid.area, &grid.x, &grid.z}) {
    rays.insert(rays.end(), part->begin(), part->end());
  }
  rays_ = Upload(rays);
}

void ShaderResolve::UploadViews() {
  std::vector<ViewBlock> blocks;
  for (const FlatView& view : layout_.views) {
    const Eigen::Vector3f right = view.right / view.tan_x;
    const Eigen::Vector3f up = view.up / view.tan_y;
    const Eigen::Vector3f& ahead = view.forward;
    blocks.push_back({{right.x(), right.y(), right.z(), 0.0f},
                      {up.x(), up.y(), up.z(), 0.0f},
                      {ahead.x(), ahead.y(), ahead.z(), 0.0f},
                      {view.first_x, view.width, view.height, 0}});
  }
  views_ = Upload(blocks);
}

void ShaderResolve::Run(std::span<const CameraPose> cameras, GLuint ids, const PictureMemory& out) {
  Dispatch(cameras, ids);
  ReadBack(cameras.size(), out);
}

void ShaderResolve::Dispatch(std::span<const CameraPose> cameras, GLuint ids) {
  std::vector<CameraBlock> blocks;
  for (const CameraPose& camera : cameras) {
    const Eigen::Vector3f& p = camera.position;
    blocks.push_back({{p.x(), p.y(), p.z(), 0.0f}, {Cos(camera.yaw), Sin(camera.yaw), 0.0f, 0.0f}});
  }
  glNamedBufferSubData(cameras_.get(), 0,
                       static_cast<GLsizeiptr>(blocks.size() * sizeof(CameraBlock)), blocks.data());
  glUseProgram(program_.get());
  const std::pair<Binding, const GlBuffer*> bindings[] = {{kCorners, &scene_.corners},
                                                          {kShading, &scene_.shading},
                                                          {kTexels, &scene_.texels},
                                                          {kTextures, &scene_.textures},
                                                          {kRays, &rays_},
                                                          {kViews, &views_},
                                                          {kCameras, &cameras_},
                                                          {kOutput, &output_}};
  for (const auto& [binding, buffer] : bindings) {
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, buffer->get());
  }
  glBindTextureUnit(0, ids);
  const auto padded = static_cast<GLint>(padded_pixels_);
  const auto n = static_cast<GLint>(cameras.size());
  glUniform4i(0, size_.rows, size_.cols, padded, n);
  glUniform2i(1, layout_.ring, static_cast<GLint>(layout_.views.size()));
  glUniform1f(2, max_depth_);
  glUniform2f(3, static_cast<float>(Cos(pitch_)), static_cast<float>(Sin(pitch_)));
  const auto groups = static_cast<GLuint>((padded / 4 + kGroupSize - 1) / kGroupSize);
  glDispatchCompute(groups, static_cast<GLuint>(n), 1);
  glMemoryBarrier(GL_CLIENT_MAPPED_BUFFER_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

void ShaderResolve::ReadBack(std::size_t cameras, const PictureMemory& out) const {
  const std::size_t bytes = kBytesAPixel * padded_pixels_ * cameras;
  const auto* mapped = static_cast<const std::uint8_t*>(
      glMapNamedBufferRange(output_.get(), 0, static_cast<GLsizeiptr>(bytes), GL_MAP_READ_BIT));
  if (mapped == nullptr) throw RenderError("the OpenGL context is lost; restart the program");
  const std::size_t pixels = size_.pixels();
  const auto* depths = reinterpret_cast<const float*>(mapped + 3 * padded_pixels_ * cameras);
  for (std::size_t i = 0; i < cameras; ++i) {
    if (!out.color.empty()) {
      std::memcpy(&out.color[3 * pixels * i], mapped + 3 * padded_pixels_ * i, 3 * pixels);
    }
    const std::span<const float> depth(depths + padded_pixels_ * i, pixels);
    if (!out.depth.empty()) CopySizes(depth, &out.depth[pixels * i]);
    if (!out.glass.empty()) CopySigns(depth, &out.glass[pixels * i]);
  }
  glUnmapNamedBuffer(output_.get());
}

}  // namespace bulletnav::sim
