// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "sim/render/egl/scene_buffers.h"
#include "sim/render/egl/views.h"
#include "sim/render/renderer.h"

namespace bulletnav::sim {

/// Turns id pictures into a camera's pictures on the device, with kResolveShader, and brings a
/// whole batch back with one readback. Its context must be current.
class ShaderResolve {
 public:
  ShaderResolve(const SceneBuffers& scene, const ViewLayout& layout, const CameraSpec& spec,
                int batch);

  /// Output as Renderer::Draw gives it, without objects.
  void Run(std::span<const CameraPose> cameras, GLuint ids, const PictureMemory& out);

 private:
  void UploadRays(const RayGrid& grid);
  void UploadViews();
  void Dispatch(std::span<const CameraPose> cameras, GLuint ids);
  void ReadBack(std::size_t cameras, const PictureMemory& out) const;

  const SceneBuffers& scene_;
  const ViewLayout& layout_;
  PictureSize size_;
  float max_depth_ = 0.0f;
  double pitch_ = 0.0;
  std::size_t padded_pixels_;  // of a camera, a multiple of 4
  GlProgram program_;
  GlBuffer rays_;
  GlBuffer views_;
  GlBuffer cameras_;
  GlBuffer output_;
};

}  // namespace bulletnav::sim
