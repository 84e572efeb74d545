// SPDX-License-Identifier: MIT
#include "sim/render/egl/chunks.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace bulletnav::sim {
namespace {

using Vec = Eigen::Vector3f;

constexpr int kTrianglesAChunk = 64;
constexpr int kTile = 8;  // pixels

}  // namespace

std::vector<Chunk> MakeChunks(std::span<const std::array<Vec, 3>> triangles) {
  std::vector<Chunk> chunks;
  const int total = static_cast<int>(triangles.size());
  for (int first = 0; first < total; first += kTrianglesAChunk) {
    Chunk chunk;
    chunk.first = first;
    chunk.count = std::min(kTrianglesAChunk, total - first);
    Eigen::AlignedBox3f box;
    for (int t = first; t < first + chunk.count; ++t) {
      for (const Vec& p : triangles[static_cast<std::size_t>(t)]) box.extend(p);
    }
    chunk.centre = box.center();
    chunk.half = 0.5f * box.sizes();
    chunks.push_back(chunk);
  }
  return chunks;
}

std::vector<ChunkInView> ChunksInView(std::span<const Chunk> chunks, const CameraPose& camera,
                                      const FlatView& view) {
  std::vector<ChunkInView> seen;
  const ViewAxes axes(view, camera);
  const std::array planes = {Vec(axes.forward + axes.right), Vec(axes.forward - axes.right),
                             Vec(axes.forward + axes.up), Vec(axes.forward - axes.up),
                             axes.forward};
  for (std::size_t i = 0; i < chunks.size(); ++i) {
    const Vec offset = chunks[i].centre - camera.position;
    const bool inside = std::all_of(planes.begin(), planes.end(), [&](const Vec& n) {
      return n.dot(offset) + n.cwiseAbs().dot(chunks[i].half) >= 0.0f;
    });
    if (!inside) continue;
    const float distance = (offset.cwiseAbs() - chunks[i].half).cwiseMax(0.0f).norm();
    seen.push_back({distance, static_cast<int>(i)});
  }
  std::sort(seen.begin(), seen.end(), [](const ChunkInView& a, const ChunkInView& b) {
    return a.distance < b.distance || (a.distance == b.distance && a.chunk < b.chunk);
  });
  return seen;
}

DepthTiles::DepthTiles(std::span<const float> depth, int width, int height)
    : columns_((width + kTile - 1) / kTile), rows_((height + kTile - 1) / kTile) {
  farthest_.assign(static_cast<std::size_t>(columns_ * rows_), 1.0f);
  for (int y = 0; y < height; ++y) {
    const float* row = &depth[static_cast<std::size_t>(y) * static_cast<std::size_t>(width)];
    float* tiles = &farthest_[static_cast<std::size_t>(y / kTile * columns_)];
    for (int x = 0; x < width; ++x) {
      float& tile = tiles[x / kTile];
      tile = std::min(tile, row[x]);
    }
  }
}

bool DepthTiles::MayShow(const Chunk& chunk, const CameraPose& camera, const FlatView& view,
                         const ViewAxes& axes, float near) const {
  const Vec offset = chunk.centre - camera.position;
  const float ahead = axes.forward.dot(offset) - axes.forward.cwiseAbs().dot(chunk.half);
  if (ahead <= near) return true;
  Eigen::AlignedBox2f outline;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec sign((corner & 1) ? 1.0f : -1.0f, (corner & 2) ? 1.0f : -1.0f,
                   (corner & 4) ? 1.0f : -1.0f);
    const Vec p = offset + chunk.half.cwiseProduct(sign);
    outline.extend(Eigen::Vector2f(axes.right.dot(p), axes.up.dot(p)) / axes.forward.dot(p));
  }
  const auto tile = [](float clip, int size, int first) {
    const float pixel = (0.5f + 0.5f * std::clamp(clip, -1.0f, 1.0f)) * static_cast<float>(size);
    return (first + std::clamp(static_cast<int>(pixel), 0, size - 1)) / kTile;
  };
  const float nearest = near / ahead;
  const int last_row = tile(outline.max().y(), view.height, 0);
  const int last_column = tile(outline.max().x(), view.width, view.first_x);
  for (int r = tile(outline.min().y(), view.height, 0); r <= last_row; ++r) {
    for (int c = tile(outline.min().x(), view.width, view.first_x); c <= last_column; ++c) {
      if (farthest_[static_cast<std::size_t>(r * columns_ + c)] < nearest) return true;
    }
  }
  return false;
}

}  // namespace bulletnav::sim
