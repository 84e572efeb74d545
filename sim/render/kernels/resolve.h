// SPDX-License-Identifier: MIT
#pragma once
// Kernels::resolve. A rasteriser samples flat views, the panorama its own rays; the four ids around
// a ray hold what it meets, up to things thinner than a pixel, which the twelve around those mostly
// hold. Each of them is met with the ray itself; the twelve only where the four do not agree. Of a
// mesh finer than pixels the one triangle that the ray meets may have been sampled nowhere: there
// the id nearest to the ray is believed although the ray just misses its triangle.
#include "sim/render/kernels/kernels.h"
#include "sim/render/kernels/simd.h"
#include "sim/render/kernels/tilt.h"

namespace bulletnav::sim {
namespace {

/// Triangles that cover less than this many pixels count as finer than pixels.
constexpr float kFinePixels = 2.0f;

/// The best hit so far of a vector of pixels. `miss` is the least edge function over their sum:
/// negative outside the triangle.
struct BestHit {
  FW inverse_t = {};
  FW miss = {};
  IW id = {};
};

/// What a vector of pixels looks for.
struct Look {
  FW ray[3];
  IW nearest_id;  // of the four, the one sampled nearest to the ray
  float area;     // of a pixel, see RayGrid
};

class Resolver {
 public:
  Resolver(const KernelScene& scene, const KernelGrid& grid, const KernelFrame& frame,
           const KernelIdPicture& picture, const KernelHits& hits)
      : scene_(scene), grid_(grid), frame_(frame), picture_(picture), hits_(hits) {}

  void Run() const {
    for (int r = 0; r < grid_.rows; ++r) {
      for (int c = 0; c < grid_.stride; c += kWidth) ResolveVector(r, c);
    }
  }

 private:
  void ResolveVector(int row, int column) const {
    const int at = row * grid_.stride + column;
    const IW encoded = Load<IW>(picture_.place + at);
    const IW place = encoded >> 2;
    const IW nearest = encoded & 3;
    Look look = {
        {Load<FW>(frame_.x + column), Splat<FW>(grid_.y[row]), Load<FW>(frame_.z + column)},
        IdsAt(place + (nearest & 1) + (nearest >> 1) * picture_.width),
        grid_.area[row]};
    MakeWorld(frame_, look.ray);
    BestHit best;
    best.miss = Splat<FW>(-1e30f);
    best.id = Splat<IW>(-1);
    IW around[4];
    IW empty = IW{};
    for (int k = 0; k < 4; ++k) {
      around[k] = IdsAt(place + (k & 1) + (k >> 1) * picture_.width);
      empty |= around[k] == 0;
      IW fresh = around[k] != 0;
      for (int j = 0; j < k; ++j) fresh &= around[k] != around[j];
      MeetAll(around[k], fresh, look, &best);
    }
    const IW unsure = (best.miss < 0.0f) | (around[0] != around[1]) | (around[0] != around[2]) |
                      (around[0] != around[3]);
    if (Bits(unsure) != 0) MeetRing(place, unsure, around, look, &best);
    // Beside an id of "nothing" a miss is a look past the mesh's rim, not through a crack in it.
    const IW none = (best.miss < 0.0f) & empty;
    Store(hits_.inverse_t + at, none ? FW{} : best.inverse_t);
    Store(hits_.id + at, none ? Splat<IW>(-1) : best.id);
  }

  /// The twelve ids around the four.
  void MeetRing(IW place, IW unsure, const IW (&around)[4], const Look& look, BestHit* best) const {
    IW last = IW{};
    for (int y = -1; y <= 2; ++y) {
      for (int x = -1; x <= 2; ++x) {
        if ((x == 0 || x == 1) && (y == 0 || y == 1)) continue;
        const IW ids = IdsAt(place + x + y * picture_.width);
        IW fresh = unsure & (ids != 0) & (ids != last);
        for (const IW& known : around) fresh &= ids != known;
        MeetAll(ids, fresh, look, best);
        last = ids;
      }
    }
  }

  /// Meets the ray of each lane in `fresh` with the triangle of its id.
  void MeetAll(IW ids, IW fresh, const Look& look, BestHit* best) const {
    std::uint32_t left = Bits(fresh);
    while (left != 0) {
      const std::int32_t id = ids[__builtin_ctz(left)] - 1;
      const IW mask = fresh & (ids == id + 1);
      left &= ~Bits(mask);
      Meet(id, look, mask, best);
    }
  }

  IW IdsAt(IW place) const { return reinterpret_cast<IW>(Gather(picture_.ids, place)); }

  void Meet(std::int32_t id, const Look& look, IW mask, BestHit* best) const {
    const float* corner = scene_.corners + 9 * static_cast<std::int64_t>(id);
    float v[3][3];
    for (int k = 0; k < 3; ++k) {
      for (int axis = 0; axis < 3; ++axis) v[k][axis] = corner[3 * k + axis] - frame_.origin[axis];
    }
    float u[3];
    float w[3];
    for (int axis = 0; axis < 3; ++axis) {
      u[axis] = v[1][axis] - v[0][axis];
      w[axis] = v[2][axis] - v[0][axis];
    }
    float normal[3];
    Cross3(u, w, normal);
    const float volume = v[0][0] * normal[0] + v[0][1] * normal[1] + v[0][2] * normal[2];
    const float side = volume < 0.0f ? -1.0f : 1.0f;
    const FW(&ray)[3] = look.ray;
    FW edge[3];
    for (int e = 0; e < 3; ++e) {
      float n[3];
      Cross3(v[(e + 1) % 3], v[(e + 2) % 3], n);
      edge[e] = side * (ray[0] * n[0] + ray[1] * n[1] + ray[2] * n[2]);
    }
    const FW facing = side * (ray[0] * normal[0] + ray[1] * normal[1] + ray[2] * normal[2]);
    const FW inverse_t = facing / (side * volume);
    const FW sum = Magnitude(edge[0]) + Magnitude(edge[1]) + Magnitude(edge[2]);
    FW miss = Min(Min(edge[0], edge[1]), edge[2]) / Max(sum, Splat<FW>(1e-30f));
    const IW fine = 0.5f * facing * inverse_t * inverse_t < kFinePixels * look.area;
    miss = (fine & (look.nearest_id == id + 1)) ? Max(miss, FW{}) : miss;
    const IW inside = miss >= 0.0f;
    const IW best_inside = best->miss >= 0.0f;
    const IW nearer = inside & (~best_inside | (inverse_t > best->inverse_t));
    const IW closer_miss = ~inside & ~best_inside & (miss > best->miss);
    const IW better = mask & (inverse_t > 0.0f) & (nearer | closer_miss);
    best->inverse_t = better ? inverse_t : best->inverse_t;
    best->miss = better ? miss : best->miss;
    best->id = better ? Splat<IW>(id) : best->id;
  }

  static FW Magnitude(FW v) { return Max(v, -v); }

  static void Cross3(const float (&a)[3], const float (&b)[3], float (&out)[3]) {
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
  }

  const KernelScene& scene_;
  const KernelGrid& grid_;
  const KernelFrame& frame_;
  const KernelIdPicture& picture_;
  const KernelHits& hits_;
};

}  // namespace
}  // namespace bulletnav::sim
