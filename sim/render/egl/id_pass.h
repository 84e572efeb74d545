// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "sim/render/egl/scene_buffers.h"
#include "sim/render/egl/views.h"

namespace bulletnav::sim {

/// Draws triangle numbers + 1 into the flat views around some cameras: a layer of
/// [layout.height, layout.width] ids for each, 0 where there is nothing. Layers, not one large
/// picture: drivers round a triangle's place differently in another part of a picture, and a camera
/// must see the same in any place of a batch. Its context must be current.
class IdPass {
 public:
  IdPass(const SceneBuffers& scene, const ViewLayout& layout, int batch);

  /// `leave_out_hidden`: draws near things first, looks at the depths, and leaves out chunks behind
  /// them; pays where triangles cost more than readbacks, that is on software drivers.
  void Draw(std::span<const CameraPose> cameras, bool leave_out_hidden);

  GLuint ids() const { return ids_.get(); }
  /// Copies the ids of the first camera.
  void ReadIds(std::vector<std::uint32_t>* ids) const;

 private:
  void Begin(std::size_t layer);
  void SetView(const CameraPose& camera, const FlatView& view);
  void DrawChunks(const std::vector<int>& chunks);
  void DrawNearToFar(const CameraPose& camera);
  /// Draws chunks but those that lie behind what the tiles say is drawn.
  void DrawThoseSeen(const CameraPose& camera, const FlatView& view,
                     std::span<const ChunkInView> items, const std::optional<DepthTiles>& tiles);
  DepthTiles ReadDepth();

  const SceneBuffers& scene_;
  const ViewLayout& layout_;
  GlProgram program_;
  GlTexture ids_;
  GlTexture depth_;
  std::vector<GlFramebuffer> framebuffers_;  // one per layer
  GlVertexArray vertices_;
  std::vector<float> depth_picture_;
  std::vector<int> firsts_;
  std::vector<int> counts_;
};

}  // namespace bulletnav::sim
