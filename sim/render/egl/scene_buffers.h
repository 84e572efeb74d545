// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <vector>

#include "sim/render/egl/chunks.h"
#include "sim/render/egl/egl_context.h"
#include "sim/render/egl/gl_objects.h"
#include "sim/render/render_mesh.h"

namespace bulletnav::sim {

/// Where the second pass runs: kAuto takes the device if it is a graphics processor and the CPU's
/// kernels under a software driver, whose compute shaders are far slower than those.
enum class ResolveOn { kAuto, kDevice, kCpu };

/// A scene's triangles in a buffer on the device, shared by the contexts of all renderers of the
/// scene. Its shading and textures are there too if `shade_on_device`, else only in `mesh`.
struct SceneBuffers {
  /// Throws RenderError if there is no device of the kind or the scene does not fit on it.
  SceneBuffers(const SceneMesh& scene, GlDevice device, ResolveOn resolve);
  ~SceneBuffers();
  SceneBuffers(const SceneBuffers&) = delete;
  SceneBuffers& operator=(const SceneBuffers&) = delete;
  SceneBuffers(SceneBuffers&&) = delete;
  SceneBuffers& operator=(SceneBuffers&&) = delete;

  EglContext context;
  bool shade_on_device = false;
  RenderMesh mesh;  // triangles in spatial order
  std::vector<Chunk> chunks;
  GlBuffer corners;
  GlBuffer shading;
  GlBuffer texels;
  GlBuffer textures;
};

}  // namespace bulletnav::sim
