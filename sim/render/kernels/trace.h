// SPDX-License-Identifier: MIT
#pragma once
// One ray at a time against eight boxes or eight triangles at once. Only kernels.cpp includes this.
#include "sim/render/kernels/bvh_layout.h"
#include "sim/render/kernels/kernels.h"
#include "sim/render/kernels/simd.h"

namespace bulletnav::sim {
namespace {

struct V3 {
  F8 x, y, z;
};

inline V3 operator+(const V3& a, const V3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline V3 operator-(const V3& a, const V3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline V3 Cross(const V3& a, const V3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline F8 Dot(const V3& a, const V3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

class Tracer {
 public:
  Tracer(const KernelScene& scene, const KernelRay& ray) : scene_(scene) {
    hit_ = {ray.far, -1};
    for (int axis = 0; axis < 3; ++axis) {
      const float d = ray.direction[axis];
      // Where a ray runs along a plane, it is near or far on both sides.
      const float inverse =
          __builtin_fabsf(d) > kFlat ? 1.0f / d : __builtin_copysignf(1 / kFlat, d);
      is_backward_[axis] = inverse < 0.0f;
      inverse_[axis] = Splat<F8>(inverse);
      // Boxes are looked at as though they were a little larger.
      const float slack = is_backward_[axis] ? -kSlack : kSlack;
      near_origin_[axis] = Splat<F8>(ray.origin[axis] + slack);
      far_origin_[axis] = Splat<F8>(ray.origin[axis] - slack);
    }
    origin_ = {Splat<F8>(ray.origin[0]), Splat<F8>(ray.origin[1]), Splat<F8>(ray.origin[2])};
    direction_ = {Splat<F8>(ray.direction[0]), Splat<F8>(ray.direction[1]),
                  Splat<F8>(ray.direction[2])};
  }

  /// The nearest hit, or, if `any` will do, the first that is found.
  KernelHit Run(bool any) {
    Waiting stack[kDeepest];
    int count = 0;
    stack[count++] = {0, 0.0f};
    while (count > 0) {
      const Waiting next = stack[--count];
      if (next.near > hit_.t) continue;
      if (next.reference >= 0) {
        count = Push(scene_.nodes[next.reference], stack, count);
        continue;
      }
      Meet(scene_.leaves[~next.reference]);
      if (any && hit_.triangle >= 0) break;
    }
    return hit_;
  }

 private:
  static constexpr float kFlat = 1e-18f;
  static constexpr float kSlack = 1e-4f;  // metres
  static constexpr int kDeepest = 256 * kBvhWidth;

  struct Waiting {
    std::int32_t reference;
    float near;
  };

  /// The children that the ray meets go onto the stack, the nearest on top.
  int Push(const BvhNode& node, Waiting* stack, int count) const {
    F8 near = {};
    F8 far = Splat<F8>(hit_.t);
    for (int axis = 0; axis < 3; ++axis) {
      const F8 low = Load<F8>(node.low[axis]);
      const F8 high = Load<F8>(node.high[axis]);
      const bool back = is_backward_[axis];
      near = Max(near, ((back ? high : low) - near_origin_[axis]) * inverse_[axis]);
      far = Min(far, ((back ? low : high) - far_origin_[axis]) * inverse_[axis]);
    }
    const int base = count;
    for (std::uint32_t met = Bits(near <= far); met != 0; met &= met - 1) {
      const int i = __builtin_ctz(met);
      const Waiting child = {node.child[i], near[i]};
      int at = count++;
      for (; at > base && stack[at - 1].near < child.near; --at) stack[at] = stack[at - 1];
      stack[at] = child;
    }
    return count;
  }

  /// Signs of volumes that ray and edges span, as in Embree's robust mode: neighbours agree about
  /// the edge they share.
  void Meet(const BvhLeaf& leaf) {
    V3 corner[3];
    for (int k = 0; k < 3; ++k) {
      corner[k] = V3{Load<F8>(leaf.corner[k][0]), Load<F8>(leaf.corner[k][1]),
                     Load<F8>(leaf.corner[k][2])} -
                  origin_;
    }
    const V3 edge0 = corner[2] - corner[0];
    const V3 edge1 = corner[0] - corner[1];
    const V3 edge2 = corner[1] - corner[2];
    const F8 u = Dot(Cross(edge0, corner[2] + corner[0]), direction_);
    const F8 v = Dot(Cross(edge1, corner[0] + corner[1]), direction_);
    const F8 w = Dot(Cross(edge2, corner[1] + corner[2]), direction_);
    const F8 zero = {};
    const I8 inside = (Min(Min(u, v), w) >= zero) | (Max(Max(u, v), w) <= zero);
    if (Bits(inside) == 0) return;
    const V3 normal = Cross(edge1, edge0);
    const F8 slope = Dot(normal, direction_);
    const F8 t = Dot(normal, corner[0]) / slope;
    std::uint32_t met = Bits(inside & (slope != zero) & (t > zero) & (t < Splat<F8>(hit_.t)));
    for (; met != 0; met &= met - 1) {
      const int i = __builtin_ctz(met);
      if (t[i] < hit_.t) hit_ = {t[i], leaf.id[i]};
    }
  }

  const KernelScene& scene_;
  KernelHit hit_;
  V3 origin_;
  V3 direction_;
  F8 near_origin_[3];
  F8 far_origin_[3];
  F8 inverse_[3];
  bool is_backward_[3];
};

}  // namespace
}  // namespace bulletnav::sim
