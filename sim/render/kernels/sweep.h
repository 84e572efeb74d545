// SPDX-License-Identifier: MIT
#pragma once
// Kernels::find_visible. All rays of a panorama start in one point, so instead of walking the
// hierarchy once a ray it is walked once a picture: nodes wait in buckets by distance; each, when
// its turn comes, is compared with a coarse grid of the farthest depths drawn so far, and dropped
// if it lies behind them or between the pixels' centres. What remains of the triangles is drawn
// with homogeneous edge functions: corner vectors a, b, c from the camera, a pixel's ray d lies
// inside if d.(b x c), d.(c x a) and d.(a x b) have one sign, and 1/t = d.n / a.n. No clipping is
// needed, and two triangles that share an edge leave no gap, since the edge's function is the same
// but for sign.
#include "sim/render/kernels/kernels.h"
#include "sim/render/kernels/simd.h"

namespace bulletnav::sim {
namespace {

constexpr float kTiny = 1e-12f;
constexpr float kNearest = 1e-6f;  // metres; nearer boxes count as around the camera
constexpr int kFixedBits = 8;      // of KernelGrid's fixed point
constexpr int kHalf = 128;         // centre of a pixel
constexpr int kTallRows = 8;       // triangles at least as tall get their rows cut per vector
constexpr float kRowTolerance = 1e-4f;

/// Columns [first, last] with last >= cols where the range runs through the seam; rows
/// [first, last]; a range may be empty.
struct PixelRect8 {
  I8 first_col;
  I8 last_col;
  I8 first_row;
  I8 last_row;
};

/// Heading of (x, z) in the camera's frame, monotonic from 0 (behind) clockwise through 2 (ahead).
inline F8 DiamondAngle(F8 x, F8 z) {
  const F8 q = x / (Abs(x) + Abs(z) + kTiny);
  return z <= 0.0f ? 2.0f + q : (x >= 0.0f ? 4.0f - q : -q);
}

/// Column of a world offset (x, z), in fixed point.
inline I8 ColumnOf(const KernelGrid& grid, const KernelFrame& frame, F8 x, F8 z) {
  const F8 right = x * frame.cos_yaw - z * frame.sin_yaw;
  const F8 back = x * frame.sin_yaw + z * frame.cos_yaw;
  return Gather(grid.column_of_angle, ToInt(DiamondAngle(right, back) * grid.angle_scale));
}

/// Row at which y is sampled, in fixed point.
inline I8 RowOf(const KernelGrid& grid, F8 y) {
  const F8 s = y / (1.0f + Abs(y));
  return Gather(grid.row_of_slope, ToInt((s + 1.0f) * grid.slope_scale));
}

inline int RowOf(const KernelGrid& grid, float y) {
  const float s = y / (1.0f + (y < 0.0f ? -y : y));
  return grid.row_of_slope[static_cast<int>((s + 1.0f) * grid.slope_scale)];
}

inline int FirstRow(const KernelGrid& grid, float highest) {
  const int row = (RowOf(grid, highest) + 255) >> kFixedBits;
  return row < 0 ? 0 : row;
}

inline int LastRow(const KernelGrid& grid, float lowest) {
  const int row = (RowOf(grid, lowest) + grid.row_slack) >> kFixedBits;
  return row >= grid.rows ? grid.rows - 1 : row;
}

/// Rows between the slopes y / hypot(x, z) of a box or triangle.
inline void SetRows(const KernelGrid& grid, F8 highest, F8 lowest, PixelRect8* rect) {
  const F8 top = Max(highest, highest * grid.xz_max);
  const F8 bottom = Min(lowest, lowest * grid.xz_max);
  rect->first_row = Max((RowOf(grid, top) + 255) >> kFixedBits, I8{});
  rect->last_row =
      Min((RowOf(grid, bottom) + grid.row_slack) >> kFixedBits, Splat<I8>(grid.rows - 1));
}

/// Columns whose centres lie in [low, high], fixed point, low in [-circle, circle).
inline void SetColumns(const KernelGrid& grid, I8 low, I8 high, I8 all, PixelRect8* rect) {
  I8 first = (low - kHalf + 255) >> kFixedBits;
  I8 last = (high + grid.column_slack - kHalf) >> kFixedBits;
  const I8 turn = ((first < 0) & grid.cols) - ((first >= grid.cols) & grid.cols);
  first += turn;
  last += turn;
  rect->first_col = all ? I8{} : first;
  rect->last_col = all ? Splat<I8>(grid.cols - 1) : last;
}

inline std::uint32_t BitsBetween(int first, int last) {
  return ((2u << (last - first)) - 1u) << first;
}

/// Tile columns that columns [first, last] touch.
inline std::uint32_t TileColumns(const KernelGrid& grid, int first, int last) {
  const int shift = grid.tile_column_shift;
  if (last < grid.cols) return BitsBetween(first >> shift, last >> shift);
  const int wrapped = last - grid.cols < grid.cols ? last - grid.cols : grid.cols - 1;
  return BitsBetween(first >> shift, (grid.cols - 1) >> shift) | BitsBetween(0, wrapped >> shift);
}

/// One sweep over one picture.
class Sweep {
 public:
  Sweep(const KernelScene& scene, const KernelGrid& grid, const KernelFrame& frame,
        const KernelScratch& scratch, const KernelHits& hits)
      : scene_(scene), grid_(grid), frame_(frame), scratch_(scratch), hits_(hits) {}

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
      scratch_.dirty[r] = 0;
    }
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
    if (entry.next >= 0) Prefetch(scratch_.entries[entry.next].reference);
    if (IsHidden(entry)) return;
    if (entry.reference < 0) {
      DrawLeaf(scene_.leaves[~entry.reference]);
    } else {
      Expand(scene_.nodes[entry.reference], bucket);
    }
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
    for (int r = 0; r < kTileRows; ++r) {
      std::uint32_t dirty = scratch_.dirty[r];
      scratch_.dirty[r] = 0;
      for (; dirty != 0; dirty &= dirty - 1) RefreshTile(r, __builtin_ctz(dirty));
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
    const F8 lx = Load<F8>(node.low[0]) - frame_.origin[0];
    const F8 ly = Load<F8>(node.low[1]) - frame_.origin[1];
    const F8 lz = Load<F8>(node.low[2]) - frame_.origin[2];
    const F8 hx = Load<F8>(node.high[0]) - frame_.origin[0];
    const F8 hy = Load<F8>(node.high[1]) - frame_.origin[1];
    const F8 hz = Load<F8>(node.high[2]) - frame_.origin[2];
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
    SetBoxColumns(lx, lz, hx, hz, around, &rect);
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

  /// Columns between the two corners of the box's outline, seen from the camera.
  void SetBoxColumns(F8 lx, F8 lz, F8 hx, F8 hz, I8 around, PixelRect8* rect) const {
    const F8 ax = lz > 0.0f ? hx : (hz < 0.0f ? lx : (lx > 0.0f ? lx : hx));
    const F8 az = lx > 0.0f ? lz : (hx < 0.0f ? hz : (lz > 0.0f ? lz : hz));
    const F8 bx = lz > 0.0f ? lx : (hz < 0.0f ? hx : (lx > 0.0f ? lx : hx));
    const F8 bz = lx > 0.0f ? hz : (hx < 0.0f ? lz : (lz > 0.0f ? lz : hz));
    const I8 a = ColumnOf(grid_, frame_, ax, az);
    const I8 b = ColumnOf(grid_, frame_, bx, bz);
    const int circle = grid_.cols << kFixedBits;
    const I8 arc = Wrapped(b - a, circle);
    const I8 low = arc < 0 ? b : a;
    const I8 length = arc < 0 ? -arc : arc;
    SetColumns(grid_, low, low + length, around, rect);
  }

  /// A difference of columns brought into [-circle / 2, circle / 2).
  static I8 Wrapped(I8 difference, int circle) {
    difference += (difference < -circle / 2) & circle;
    difference -= (difference >= circle / 2) & circle;
    return difference;
  }

  /// The triangles of a leaf as seen from the camera, side by side.
  struct Setup {
    F8 edge[3][3];    // [edge][axis] normals of the planes through the camera and an edge
    F8 inverse_t[3];  // n / (a.n): 1 / t = d . inverse_t
    PixelRect8 rect;
    I8 usable;
  };

  void DrawLeaf(const BvhLeaf& leaf) {
    Setup setup;
    SetUp(leaf, &setup);
    std::uint32_t left = Bits(setup.usable) & ((1u << leaf.count) - 1u);
    if (left == 0) return;
    alignas(64) float planes[12][kBvhWidth];
    for (int e = 0; e < 3; ++e) {
      for (int axis = 0; axis < 3; ++axis) Store(planes[3 * e + axis], setup.edge[e][axis]);
      Store(planes[9 + e], setup.inverse_t[e]);
    }
    for (; left != 0; left &= left - 1) {
      const int i = __builtin_ctz(left);
      Triangle triangle;
      for (int k = 0; k < 12; ++k) triangle.plane[k] = planes[k][i];
      triangle.id = leaf.id[i];
      triangle.first_row = setup.rect.first_row[i];
      triangle.last_row = setup.rect.last_row[i];
      DrawColumns(triangle, setup.rect.first_col[i], setup.rect.last_col[i]);
    }
  }

  void SetUp(const BvhLeaf& leaf, Setup* out) const {
    F8 v[3][3];
    for (int k = 0; k < 3; ++k) {
      for (int axis = 0; axis < 3; ++axis) {
        v[k][axis] = Load<F8>(leaf.corner[k][axis]) - frame_.origin[axis];
      }
    }
    for (int e = 0; e < 3; ++e) Cross(v[(e + 1) % 3], v[(e + 2) % 3], out->edge[e]);
    F8 u[3];
    F8 w[3];
    for (int axis = 0; axis < 3; ++axis) {
      u[axis] = v[1][axis] - v[0][axis];
      w[axis] = v[2][axis] - v[0][axis];
    }
    F8 normal[3];
    Cross(u, w, normal);
    const F8 volume = Dot(v[0], normal);
    const I8 sign = reinterpret_cast<I8>(volume) & static_cast<std::int32_t>(0x80000000);
    for (auto& edge : out->edge) {
      for (F8& x : edge) x = reinterpret_cast<F8>(reinterpret_cast<I8>(x) ^ sign);
    }
    for (int axis = 0; axis < 3; ++axis) out->inverse_t[axis] = normal[axis] / volume;
    // A plane that passes within a micrometre of the camera is seen from its edge.
    const I8 solid = volume * volume > 1e-12f * Dot(normal, normal);
    SetTriangleRect(v, u, w, &out->rect);
    out->usable = solid & (out->rect.first_row <= out->rect.last_row) &
                  (out->rect.first_col <= out->rect.last_col);
  }

  void SetTriangleRect(const F8 (&v)[3][3], const F8 (&u)[3], const F8 (&w)[3],
                       PixelRect8* rect) const {
    const I8 a = ColumnOf(grid_, frame_, v[0][0], v[0][2]);
    const I8 b = ColumnOf(grid_, frame_, v[1][0], v[1][2]);
    const I8 c = ColumnOf(grid_, frame_, v[2][0], v[2][2]);
    const int circle = grid_.cols << kFixedBits;
    const I8 ab = Wrapped(b - a, circle);
    const I8 ac = Wrapped(c - a, circle);
    const I8 low = Min(Min(ab, ac), I8{});
    const I8 high = Max(Max(ab, ac), I8{});
    // Half a circle or more: the triangle passes over, under or through the camera's axis.
    const I8 around = high - low >= circle / 2 - 4 * grid_.column_slack;
    SetColumns(grid_, a + low, a + high, around, rect);
    F8 squared[3];
    for (int k = 0; k < 3; ++k) squared[k] = v[k][0] * v[k][0] + v[k][2] * v[k][2];
    const F8 tx = w[0] - u[0];
    const F8 tz = w[2] - u[2];
    const F8 longest =
        Max(Max(u[0] * u[0] + u[2] * u[2], w[0] * w[0] + w[2] * w[2]), tx * tx + tz * tz);
    // An edge comes nearer to the axis than its ends, but not by more than this.
    const F8 nearest = Min(Min(squared[0], squared[1]), squared[2]) - 0.25f * longest;
    const F8 farthest = Max(Max(squared[0], squared[1]), squared[2]);
    const F8 inverse_near = 1.001f / Sqrt(Max(nearest, Splat<F8>(kNearest * kNearest)));
    const F8 inverse_far = 0.999f / Sqrt(Max(farthest, Splat<F8>(kNearest * kNearest)));
    const F8 highest = Max(Max(v[0][1], v[1][1]), v[2][1]);
    const F8 lowest = Min(Min(v[0][1], v[1][1]), v[2][1]);
    SetRows(grid_, highest * (highest > 0.0f ? inverse_near : inverse_far),
            lowest * (lowest > 0.0f ? inverse_far : inverse_near), rect);
  }

  static void Cross(const F8 (&a)[3], const F8 (&b)[3], F8 (&out)[3]) {
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
  }

  static F8 Dot(const F8 (&a)[3], const F8 (&b)[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }

  struct Triangle {
    float plane[12];  // three edges, then 1 / t; x, y, z of each
    std::int32_t id;
    int first_row;
    int last_row;
  };

  void DrawColumns(const Triangle& triangle, int first, int last) {
    if (last < grid_.cols) {
      DrawVectors(triangle, first / kWidth, last / kWidth);
      return;
    }
    const int wrapped = last - grid_.cols < first ? last - grid_.cols : first - 1;
    DrawVectors(triangle, first / kWidth, (grid_.cols - 1) / kWidth);
    if (wrapped >= 0) DrawVectors(triangle, 0, wrapped / kWidth);
  }

  void DrawVectors(const Triangle& triangle, int first, int last) {
    for (int v = first; v <= last; ++v) DrawVector(triangle, v * kWidth);
  }

  /// One vector of columns, all of its rows.
  void DrawVector(const Triangle& triangle, int column) {
    const FW x = Load<FW>(frame_.x + column);
    const FW z = Load<FW>(frame_.z + column);
    FW base[4];
    for (int k = 0; k < 4; ++k) {
      base[k] = x * triangle.plane[3 * k] + z * triangle.plane[3 * k + 2];
    }
    int first = triangle.first_row;
    int last = triangle.last_row;
    if (last - first >= kTallRows) CutRows(triangle, base, &first, &last);
    if (first > last) return;
    DrawRows(triangle, base, column, first, last);
    const std::uint32_t tile = 1u << (column >> grid_.tile_column_shift);
    const int last_tile = last >> grid_.tile_row_shift;
    for (int r = first >> grid_.tile_row_shift; r <= last_tile; ++r) scratch_.dirty[r] |= tile;
  }

  /// Everything is read before the loop: the compiler must take any store for one that changes it.
  void DrawRows(const Triangle& triangle, const FW (&base)[4], int column, int first,
                int last) const {
    const IW id = Splat<IW>(triangle.id);
    const FW slope0 = Splat<FW>(triangle.plane[1]);
    const FW slope1 = Splat<FW>(triangle.plane[4]);
    const FW slope2 = Splat<FW>(triangle.plane[7]);
    const FW slope3 = Splat<FW>(triangle.plane[10]);
    const FW base0 = base[0];
    const FW base1 = base[1];
    const FW base2 = base[2];
    const FW base3 = base[3];
    const float* y = grid_.y + first;
    const float* const end = grid_.y + last;
    const int stride = grid_.stride;
    float* inverse_t = hits_.inverse_t + first * stride + column;
    std::int32_t* ids = hits_.id + first * stride + column;
    for (; y <= end; ++y, inverse_t += stride, ids += stride) {
      const FW inside = Min(Min(base0 + slope0 * *y, base1 + slope1 * *y), base2 + slope2 * *y);
      const FW hit = inside >= 0.0f ? base3 + slope3 * *y : FW{};
      const FW old = Load<FW>(inverse_t);
      const IW nearer = hit > old;
      Store(inverse_t, nearer ? hit : old);
      Store(ids, nearer ? id : Load<IW>(ids));
    }
  }

  /// Narrows the rows to those where some lane can be inside: each edge function is linear in y.
  void CutRows(const Triangle& triangle, const FW (&base)[4], int* first, int* last) const {
    FW lowest = Splat<FW>(-1e30f);
    FW highest = Splat<FW>(1e30f);
    for (int e = 0; e < 3; ++e) {
      const float slope = triangle.plane[3 * e + 1];
      if (slope == 0.0f) continue;
      const FW zero = base[e] * (-1.0f / slope);
      if (slope > 0.0f) {
        lowest = Max(lowest, zero);
      } else {
        highest = Min(highest, zero);
      }
    }
    const FW reach = highest + kRowTolerance * (1.0f + Max(highest, -highest));
    const IW some = lowest <= reach;
    const float top = -SmallestLane(some ? -reach : Splat<FW>(1e30f));
    const float bottom = SmallestLane(some ? lowest : Splat<FW>(1e30f));
    if (top < bottom) {
      *first = *last + 1;
      return;
    }
    const int cut_first = FirstRow(grid_, top);
    const int cut_last = LastRow(grid_, bottom - kRowTolerance);
    *first = cut_first > *first ? cut_first : *first;
    *last = cut_last < *last ? cut_last : *last;
  }

  const KernelScene& scene_;
  const KernelGrid& grid_;
  const KernelFrame& frame_;
  const KernelScratch& scratch_;
  const KernelHits& hits_;
  std::int32_t entries_ = 0;
};

}  // namespace
}  // namespace bulletnav::sim
