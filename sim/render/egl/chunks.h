// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "sim/render/egl/views.h"

namespace bulletnav::sim {

/// A run of triangles that lie together, and the box around them.
struct Chunk {
  Eigen::Vector3f centre = Eigen::Vector3f::Zero();
  Eigen::Vector3f half = Eigen::Vector3f::Zero();
  int first = 0;  // triangle
  int count = 0;
};

/// Cuts triangles, ordered so that neighbours stand together, into chunks.
std::vector<Chunk> MakeChunks(std::span<const std::array<Eigen::Vector3f, 3>> triangles);

/// A chunk that a view may see.
struct ChunkInView {
  float distance = 0.0f;  // of the box from the camera
  int chunk = 0;
};

/// The chunks inside a view's frustum, nearest first.
std::vector<ChunkInView> ChunksInView(std::span<const Chunk> chunks, const CameraPose& camera,
                                      const FlatView& view);

/// Coarse picture of the farthest depths drawn so far, to leave out what lies behind them. Depths
/// are reversed: near plane / distance along the view, 0 = nothing.
class DepthTiles {
 public:
  /// Rows from below, as OpenGL returns them.
  DepthTiles(std::span<const float> depth, int width, int height);

  /// Whether a chunk may show in a view: some tile that its box touches is farther than the box.
  bool MayShow(const Chunk& chunk, const CameraPose& camera, const FlatView& view,
               const ViewAxes& axes, float near) const;

 private:
  int columns_ = 0;
  int rows_ = 0;
  std::vector<float> farthest_;
};

}  // namespace bulletnav::sim
