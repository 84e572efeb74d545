// SPDX-License-Identifier: MIT
#pragma once
// Triangles of a leaf become pixels, by homogeneous edge functions: with the corners a, b, c from
// the camera, a pixel's ray d lies inside if d.(b x c), d.(c x a) and d.(a x b) have one sign, and
// 1/t = d.n / a.n. No clipping is needed, and two triangles that share an edge leave no gap, since
// the edge's function is the same except for sign.
#include "sim/render/kernels/kernels.h"
#include "sim/render/kernels/pixel_bounds.h"
#include "sim/render/kernels/simd.h"
#include "sim/render/kernels/tilt.h"

namespace bulletnav::sim {
namespace {

constexpr int kTallRows = 8;  // triangles at least as tall get their rows cut per vector
constexpr float kRowTolerance = 1e-4f;

/// Draws leaves into one picture.
class LeafPainter {
 public:
  LeafPainter(const KernelGrid& grid, const KernelFrame& frame, const KernelHits& hits,
              std::uint16_t* dirty, bool back_faces)
      : grid_(grid), frame_(frame), hits_(hits), dirty_(dirty), back_faces_(back_faces) {}

  /// Writes what is nearer than what is there. Of triangles that are equally near the first stays.
  void Draw(const BvhLeaf& leaf) {
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
      const Triangle triangle = {&planes[0][i], leaf.id[i], setup.rect.first_row[i],
                                 setup.rect.last_row[i]};
      DrawColumns(triangle, setup.rect.first_col[i], setup.rect.last_col[i]);
    }
  }

 private:
  /// The triangles of a leaf as seen from the camera, side by side.
  struct Setup {
    F8 edge[3][3];    // [edge][axis] normals of the planes through the camera and an edge
    F8 inverse_t[3];  // n / (a.n): 1 / t = d . inverse_t
    PixelRect8 rect;
    I8 usable;
  };

  struct Triangle {
    const float* planes;  // three edges, then 1 / t; x, y, z of each; see plane()
    std::int32_t id;
    int first_row;
    int last_row;
    float plane(int k) const { return planes[k * kBvhWidth]; }
  };

  void SetUp(const BvhLeaf& leaf, Setup* out) const {
    F8 v[3][3];
    for (int k = 0; k < 3; ++k) {
      for (int axis = 0; axis < 3; ++axis) {
        v[k][axis] = Load<F8>(leaf.corner[k][axis]) - frame_.origin[axis];
      }
      MakeLevel(frame_, v[k]);
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
    SetTriangleRect(grid_, frame_, v, u, w, &out->rect);
    // The normal points to where corners go anticlockwise: away from the camera behind.
    const I8 faces = back_faces_ ? solid : solid & (volume < 0.0f);
    out->usable = faces & (out->rect.first_row <= out->rect.last_row) &
                  (out->rect.first_col <= out->rect.last_col);
  }

  static void Cross(const F8 (&a)[3], const F8 (&b)[3], F8 (&out)[3]) {
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
  }

  static F8 Dot(const F8 (&a)[3], const F8 (&b)[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }

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
      base[k] = x * triangle.plane(3 * k) + z * triangle.plane(3 * k + 2);
    }
    int first = triangle.first_row;
    int last = triangle.last_row;
    if (last - first >= kTallRows) CutRows(triangle, base, &first, &last);
    if (first > last) return;
    DrawRows(triangle, base, column, first, last);
    dirty_[column >> grid_.tile_column_shift] |= static_cast<std::uint16_t>(
        BitsBetween(first >> grid_.tile_row_shift, last >> grid_.tile_row_shift));
  }

  /// Everything is read before the loop: the compiler must take any store for one that changes it.
  void DrawRows(const Triangle& triangle, const FW (&base)[4], int column, int first,
                int last) const {
    const IW id = Splat<IW>(triangle.id);
    const FW slope0 = Splat<FW>(triangle.plane(1));
    const FW slope1 = Splat<FW>(triangle.plane(4));
    const FW slope2 = Splat<FW>(triangle.plane(7));
    const FW slope3 = Splat<FW>(triangle.plane(10));
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
      const float slope = triangle.plane(3 * e + 1);
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

  const KernelGrid& grid_;
  const KernelFrame& frame_;
  const KernelHits& hits_;
  std::uint16_t* dirty_;  // as in KernelScratch
  bool back_faces_;
};

}  // namespace
}  // namespace bulletnav::sim
