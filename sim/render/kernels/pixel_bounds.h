// SPDX-License-Identifier: MIT
#pragma once
// Which pixels a box or a triangle may cover, eight of them at a time: never too few, seldom one
// too many. Headings and slopes become columns and rows by KernelGrid's tables.
#include "sim/render/kernels/kernels.h"
#include "sim/render/kernels/simd.h"

namespace bulletnav::sim {
namespace {

constexpr float kTiny = 1e-12f;
constexpr float kNearest = 1e-6f;  // metres; nearer boxes count as around the camera
constexpr int kFixedBits = 8;      // of KernelGrid's fixed point
constexpr int kHalf = 128;         // centre of a pixel

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

/// Columns whose centres lie in [low, high], fixed point; low is within a circle of the picture,
/// high less than half a circle above it.
inline void SetColumns(const KernelGrid& grid, I8 low, I8 high, I8 all, PixelRect8* rect) {
  I8 first = (low - kHalf + 255) >> kFixedBits;
  I8 last = (high + grid.column_slack - kHalf) >> kFixedBits;
  if (grid.circle != grid.cols) {
    // The picture does not go round: ranges that start right of it may come in from the left.
    const I8 shift =
        ((first < grid.cols - grid.circle) & grid.circle) - ((first >= grid.cols) & grid.circle);
    first = Max(first + shift, I8{});
    last = Min(last + shift, Splat<I8>(grid.cols - 1));
    rect->first_col = all ? I8{} : first;
    rect->last_col = all ? Splat<I8>(grid.cols - 1) : last;
    return;
  }
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

/// A difference of columns brought into [-circle / 2, circle / 2).
inline I8 Wrapped(I8 difference, int circle) {
  difference += (difference < -circle / 2) & circle;
  difference -= (difference >= circle / 2) & circle;
  return difference;
}

/// Columns between the two corners of the box's outline, seen from the camera.
inline void SetBoxColumns(const KernelGrid& grid, const KernelFrame& frame, F8 lx, F8 lz, F8 hx,
                          F8 hz, I8 around, PixelRect8* rect) {
  const F8 ax = lz > 0.0f ? hx : (hz < 0.0f ? lx : (lx > 0.0f ? lx : hx));
  const F8 az = lx > 0.0f ? lz : (hx < 0.0f ? hz : (lz > 0.0f ? lz : hz));
  const F8 bx = lz > 0.0f ? lx : (hz < 0.0f ? hx : (lx > 0.0f ? lx : hx));
  const F8 bz = lx > 0.0f ? hz : (hx < 0.0f ? lz : (lz > 0.0f ? lz : hz));
  const I8 a = ColumnOf(grid, frame, ax, az);
  const I8 b = ColumnOf(grid, frame, bx, bz);
  const int circle = grid.circle << kFixedBits;
  const I8 arc = Wrapped(b - a, circle);
  const I8 low = arc < 0 ? b : a;
  const I8 length = arc < 0 ? -arc : arc;
  // Of a box that the camera all but touches, rounding may take the wrong side.
  const I8 touched = around | (length >= circle / 2 - 4 * grid.column_slack);
  SetColumns(grid, low, low + length, touched, rect);
}

/// Bounds of triangles with the corners v[corner][axis] from the camera; u and w are their edges
/// from corner 0 to corners 1 and 2.
inline void SetTriangleRect(const KernelGrid& grid, const KernelFrame& frame, const F8 (&v)[3][3],
                            const F8 (&u)[3], const F8 (&w)[3], PixelRect8* rect) {
  const I8 a = ColumnOf(grid, frame, v[0][0], v[0][2]);
  const I8 b = ColumnOf(grid, frame, v[1][0], v[1][2]);
  const I8 c = ColumnOf(grid, frame, v[2][0], v[2][2]);
  const int circle = grid.circle << kFixedBits;
  const I8 ab = Wrapped(b - a, circle);
  const I8 ac = Wrapped(c - a, circle);
  const I8 low = Min(Min(ab, ac), I8{});
  const I8 high = Max(Max(ab, ac), I8{});
  // Half a circle or more: the triangle passes over, under or through the camera's axis.
  const I8 around = high - low >= circle / 2 - 4 * grid.column_slack;
  SetColumns(grid, a + low, a + high, around, rect);
  F8 squared[3];
  for (int k = 0; k < 3; ++k) squared[k] = v[k][0] * v[k][0] + v[k][2] * v[k][2];
  const F8 tx = w[0] - u[0];
  const F8 tz = w[2] - u[2];
  const F8 longest =
      Max(Max(u[0] * u[0] + u[2] * u[2], w[0] * w[0] + w[2] * w[2]), tx * tx + tz * tz);
  // An edge comes nearer to the axis than its ends, but not by more than this; a triangle that the
  // axis passes through comes as near as can be.
  const F8 least = Min(Min(squared[0], squared[1]), squared[2]);
  const F8 nearest = around ? F8{} : 0.999999f * least - 0.250001f * longest;
  const F8 farthest = Max(Max(squared[0], squared[1]), squared[2]);
  const F8 inverse_near = 1.00001f / Sqrt(Max(nearest, Splat<F8>(kNearest * kNearest)));
  const F8 inverse_far = 0.99999f / Sqrt(Max(farthest, Splat<F8>(kNearest * kNearest)));
  const F8 highest = Max(Max(v[0][1], v[1][1]), v[2][1]);
  const F8 lowest = Min(Min(v[0][1], v[1][1]), v[2][1]);
  SetRows(grid, highest * (highest > 0.0f ? inverse_near : inverse_far),
          lowest * (lowest > 0.0f ? inverse_far : inverse_near), rect);
}

}  // namespace
}  // namespace bulletnav::sim
