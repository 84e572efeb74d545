// SPDX-License-Identifier: MIT
#pragma once
// Kernels::find_visible. All rays of a panorama start in one point, so instead of walking the
// hierarchy once a ray it is walked once a picture: nodes wait in buckets by distance; each, when
// its turn comes, is compared with a coarse grid of the farthest depths drawn so far, and dropped
// if it lies behind them or between the pixels' centres. What remains is drawn by LeafPainter.
#include "sim/render/kernels/kernels.h"
#include "sim/render/kernels/leaf_painter.h"
#include "sim/render/kernels/pixel_bounds.h"
#include "sim/render/kernels/simd.h"
#include "sim/render/kernels/tilt.h"

namespace bulletnav::sim {
namespace {

/// One sweep over one picture.
class Sweep {
 public:
  Sweep(const KernelScene& scene, const KernelGrid& grid, const KernelFrame& frame,
        const KernelScratch& scratch, const KernelHits& hits)
      : scene_(scene),
        grid_(grid),
        frame_(frame),
        scratch_(scratch),
        hits_(hits),
        painter_(grid, frame, hits, scratch.dirty, scene.back_faces) {}

  void Run() {
    Clear();
    Push({0, 1.0f / kNearest, ~0u, 0, static_cast<std::int16_t>(grid_.rows - 1), -1}, 0);
    for (int bucket = 0; bucket < kBuckets; ++bucket) {
      if (scratch_.buckets[bucket] < 0) continue;
      RefreshTiles();
      while (scratch_.buckets[bucket] >= 0) Visit(bucket);
    }
  }

 private:
  void Clear() {
    const int tile_columns = 1 << grid_.tile_column_shift;
    for (int r = 0; r < grid_.rows; ++r) {
      float* row = hits_.inverse_t + r * grid_.stride;
      for (int c = 0; c < grid_.stride; c += kWidth) {
        Store(row + c, FW{});
        Store(hits_.id + r * grid_.stride + c, Splat<IW>(-1));
      }
      // Pixels beyond the last column count as drawn at the camera: nothing is nearer.
      for (int c = grid_.cols; c < grid_.stride; ++c) row[c] = 1.0f / kTiny;
    }
    for (int r = 0; r < kTileRows; ++r) {
      const bool inside = r << grid_.tile_row_shift < grid_.rows;
      for (int c = 0; c < kTileColumns; ++c) {
        scratch_.tile_farthest[r * kTileColumns + c] =
            inside && c * tile_columns < grid_.cols ? 0.0f : 1.0f / kTiny;
      }
    }
    for (int c = 0; c < kTileColumns; ++c) scratch_.dirty[c] = 0;
    for (int b = 0; b < kBuckets; ++b) scratch_.buckets[b] = -1;
    entries_ = 0;
  }

  void Push(const QueueEntry& entry, int bucket) {
    QueueEntry& slot = scratch_.entries[entries_];
    slot = entry;
    slot.next = scratch_.buckets[bucket];
    scratch_.buckets[bucket] = entries_++;
  }

  void Visit(int bucket) {
    const QueueEntry entry = scratch_.entries[scratch_.buckets[bucket]];
    scratch_.buckets[bucket] = entry.next;
    if (entry.next >= 0) {
      const QueueEntry& next = scratch_.entries[entry.next];
      Prefetch(next.reference);
    }
    if (IsHidden(entry)) return;
    const std::int32_t reference = WithDetail(entry);
    if (reference < 0) {
      painter_.Draw(scene_.leaves[~reference]);
    } else {
      Expand(scene_.nodes[reference], bucket);
    }
  }

  /// The entry's node or leaf, or the coarse one that may be drawn for it.
  std::int32_t WithDetail(const QueueEntry& entry) const {
    std::int32_t reference = entry.reference;
    while (reference >= 0 && scene_.nodes[reference].count == kDetailNode) {
      const BvhNode& node = scene_.nodes[reference];
      const bool is_far = node.low[0][0] * entry.inverse_near <= grid_.half_pixel;
      reference = node.child[is_far ? 1 : 0];
    }
    return reference;
  }

  void Prefetch(std::int32_t reference) const {
    const char* at = reference < 0 ? reinterpret_cast<const char*>(scene_.leaves + ~reference)
                                   : reinterpret_cast<const char*>(scene_.nodes + reference);
    for (int offset = 0; offset < 384; offset += 64) __builtin_prefetch(at + offset);
  }

  /// Whether everything the entry may cover is already nearer than the entry can be.
  bool IsHidden(const QueueEntry& entry) const {
    const int last = entry.last_row >> grid_.tile_row_shift;
    for (int r = entry.first_row >> grid_.tile_row_shift; r <= last; ++r) {
      const float* tiles = scratch_.tile_farthest + r * kTileColumns;
      std::uint32_t open = 0;
      for (int c = 0; c < kTileColumns; c += kWidth) {
        open |= Bits(Load<FW>(tiles + c) < entry.inverse_near) << c;
      }
      if ((open & entry.tile_columns) != 0) return false;
    }
    return true;
  }

  void RefreshTiles() {
    for (int c = 0; c < kTileColumns; ++c) {
      std::uint32_t dirty = scratch_.dirty[c];
      scratch_.dirty[c] = 0;
      for (; dirty != 0; dirty &= dirty - 1) RefreshTile(__builtin_ctz(dirty), c);
    }
  }

  void RefreshTile(int tile_row, int tile_column) {
    const int first_row = tile_row << grid_.tile_row_shift;
    const int height = 1 << grid_.tile_row_shift;
    const int end_row = first_row + height < grid_.rows ? first_row + height : grid_.rows;
    const int first_col = tile_column << grid_.tile_column_shift;
    const int width = 1 << grid_.tile_column_shift;
    const int end_col = first_col + width < grid_.stride ? first_col + width : grid_.stride;
    FW farthest = Splat<FW>(1.0f / kTiny);
    for (int r = first_row; r < end_row; ++r) {
      const float* row = hits_.inverse_t + r * grid_.stride;
      for (int c = first_col; c < end_col; c += kWidth) farthest = Min(farthest, Load<FW>(row + c));
    }
    scratch_.tile_farthest[tile_row * kTileColumns + tile_column] = SmallestLane(farthest);
  }

  /// Puts the node's children that may be seen into their buckets.
  void Expand(const BvhNode& node, int bucket) {
    F8 low[3];
    F8 high[3];
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = Load<F8>(node.low[axis]) - frame_.origin[axis];
      high[axis] = Load<F8>(node.high[axis]) - frame_.origin[axis];
    }
    MakeBoxLevel(frame_, low, high);
    const auto [lx, ly, lz] = low;
    const auto [hx, hy, hz] = high;
    const F8 dx = Max(Max(lx, -hx), F8{});
    const F8 dz = Max(Max(lz, -hz), F8{});
    const F8 near = Sqrt(dx * dx + dz * dz);
    const I8 around = near < kNearest;
    const F8 fx = Max(-lx, hx);
    const F8 fz = Max(-lz, hz);
    const F8 inverse_far = 1.0f / Sqrt(fx * fx + fz * fz);
    const F8 inverse_near = 1.0f / Max(near, Splat<F8>(kNearest));
    PixelRect8 rect;
    SetRows(grid_, hy * (hy > 0.0f ? inverse_near : inverse_far),
            ly * (ly > 0.0f ? inverse_far : inverse_near), &rect);
    SetBoxColumns(grid_, frame_, lx, lz, hx, hz, around, &rect);
    const I8 seen = (rect.first_row <= rect.last_row) & (rect.first_col <= rect.last_col);
    const I8 in_bucket =
        ToInt(Min(near * kBucketsPerMetre, Splat<F8>(static_cast<float>(kBuckets - 1))));
    std::uint32_t left = Bits(seen) & ((1u << node.count) - 1u);
    for (; left != 0; left &= left - 1) {
      const int i = __builtin_ctz(left);
      const QueueEntry entry{node.child[i],
                             inverse_near[i] * grid_.xz_max,
                             TileColumns(grid_, rect.first_col[i], rect.last_col[i]),
                             static_cast<std::int16_t>(rect.first_row[i]),
                             static_cast<std::int16_t>(rect.last_row[i]),
                             -1};
      if (!IsHidden(entry)) Push(entry, in_bucket[i] > bucket ? in_bucket[i] : bucket);
    }
  }

  const KernelScene& scene_;
  const KernelGrid& grid_;
  const KernelFrame& frame_;
  const KernelScratch& scratch_;
  const KernelHits& hits_;
  LeafPainter painter_;
  std::int32_t entries_ = 0;
};

}  // namespace
}  // namespace bulletnav::sim
