// SPDX-License-Identifier: MIT
#include "sim/render/egl/scene_buffers.h"

#include <string>

#include "sim/base/error.h"
#include "sim/render/cpu/bvh.h"

namespace bulletnav::sim {
namespace {

/// Puts triangles into the order in which the hierarchy's leaves hold them: neighbours in space
/// become neighbours in memory, and chunks of the list are compact.
RenderMesh InSpatialOrder(const SceneMesh& scene) {
  RenderMesh mesh(scene);
  std::vector<std::array<Eigen::Vector3f, 3>> corners;
  std::vector<TriangleShading> shading;
  std::vector<std::uint32_t> objects;
  for (const BvhLeaf& leaf : Bvh(mesh.corners).leaves) {
    for (int i = 0; i < leaf.count; ++i) {
      corners.push_back(mesh.corners[static_cast<std::size_t>(leaf.id[i])]);
      shading.push_back(mesh.shading[static_cast<std::size_t>(leaf.id[i])]);
      if (mesh.objects.empty()) continue;
      objects.push_back(mesh.objects[static_cast<std::size_t>(leaf.id[i])]);
    }
  }
  mesh.corners = std::move(corners);
  mesh.shading = std::move(shading);
  mesh.objects = std::move(objects);
  return mesh;
}

void CheckFits(const RenderMesh& mesh) {
  GLint64 largest = 0;
  glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &largest);
  const std::size_t needed =
      std::max(mesh.shading.size() * sizeof(TriangleShading), mesh.textures.texels.size() * 4);
  if (needed > static_cast<std::size_t>(largest)) {
    throw RenderError("the scene needs a buffer of " + std::to_string(needed >> 20) +
                      " MB, more than this OpenGL driver allows; use the embree backend");
  }
}

template <class T>
GlBuffer Upload(const std::vector<T>& values) {
  return NewBuffer(std::as_bytes(std::span(values)));
}

}  // namespace

SceneBuffers::SceneBuffers(const SceneMesh& scene, GlDevice device, ResolveOn resolve)
    : context(device), mesh(InSpatialOrder(scene)), chunks(MakeChunks(mesh.corners)) {
  shade_on_device =
      resolve == ResolveOn::kDevice || (resolve == ResolveOn::kAuto && context.is_hardware());
  const EglContext::Current current(context);
  corners = Upload(mesh.corners);
  if (shade_on_device) {
    CheckFits(mesh);
    shading = Upload(mesh.shading);
    texels = Upload(mesh.textures.texels);
    textures = Upload(mesh.textures.infos);
  }
  glFinish();  // other contexts see the buffers only when they are complete
}

SceneBuffers::~SceneBuffers() {
  const EglContext::Current current(context);
  for (GlBuffer* buffer : {&corners, &shading, &texels, &textures}) *buffer = GlBuffer();
}

}  // namespace bulletnav::sim
