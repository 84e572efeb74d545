// SPDX-License-Identifier: MIT
#pragma once
#include "sim/render/kernels/simd.h"
#include "sim/render/triangle_shading.h"

namespace bulletnav::sim {
namespace {

using F4 = float __attribute__((vector_size(16)));
using I4 = std::int32_t __attribute__((vector_size(16)));

/// The records of as many triangles as there are lanes, a field's values side by side.
class TriangleShadings {
 public:
  TriangleShadings(const TriangleShading* records, IW ids) {
    for (int lane = 0; lane < kWidth; lane += 4) {
      const TriangleShading* from[4];
      for (int i = 0; i < 4; ++i) from[i] = records + ids[lane + i];
      for (int quad = 0; quad < 6; ++quad) {
        const F4 a = Quad(from[0], quad);
        const F4 b = Quad(from[1], quad);
        const F4 c = Quad(from[2], quad);
        const F4 d = Quad(from[3], quad);
        const F4 ab_low = __builtin_shufflevector(a, b, 0, 4, 1, 5);
        const F4 ab_high = __builtin_shufflevector(a, b, 2, 6, 3, 7);
        const F4 cd_low = __builtin_shufflevector(c, d, 0, 4, 1, 5);
        const F4 cd_high = __builtin_shufflevector(c, d, 2, 6, 3, 7);
        Store(&field_[4 * quad][lane], __builtin_shufflevector(ab_low, cd_low, 0, 1, 4, 5));
        Store(&field_[4 * quad + 1][lane], __builtin_shufflevector(ab_low, cd_low, 2, 3, 6, 7));
        Store(&field_[4 * quad + 2][lane], __builtin_shufflevector(ab_high, cd_high, 0, 1, 4, 5));
        Store(&field_[4 * quad + 3][lane], __builtin_shufflevector(ab_high, cd_high, 2, 3, 6, 7));
      }
    }
  }
  FW g1(int i) const { return Load<FW>(field_[i]); }
  FW h1() const { return Load<FW>(field_[3]); }
  FW g2(int i) const { return Load<FW>(field_[4 + i]); }
  FW h2() const { return Load<FW>(field_[7]); }
  FW uv0(int i) const { return Load<FW>(field_[8 + i]); }
  FW duv1(int i) const { return Load<FW>(field_[10 + i]); }
  FW duv2(int i) const { return Load<FW>(field_[12 + i]); }
  UW color(int i) const { return Load<UW>(field_[14 + i]); }
  IW texture() const { return Load<IW>(field_[17]); }
  FW normal(int i) const { return Load<FW>(field_[18 + i]); }
  FW plane() const { return Load<FW>(field_[21]); }
  FW texel_density() const { return Load<FW>(field_[22]); }

 private:
  static F4 Quad(const TriangleShading* from, int quad) {
    return Load<F4>(reinterpret_cast<const char*>(from) + 16 * quad);
  }

  alignas(64) float field_[24][kWidth];
};

}  // namespace
}  // namespace bulletnav::sim
