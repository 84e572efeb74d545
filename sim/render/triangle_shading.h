// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

namespace bulletnav::sim {

/// What shading needs of one triangle. For a point P on it the barycentric weights of corners 1 and
/// 2 are b1 = g1.P + h1 and b2 = g2.P + h2, clamped to the triangle; then
/// uv = uv0 + b1 duv1 + b2 duv2 and the colour in the same way. 96 bytes, the layout of the GPU's
/// buffer.
///
/// Both backends pick the texture level alike: with
///   texels = texel_density * area[row] * t^3 / |plane distance|   (see RayGrid::area)
/// the level is exponent(2 * texels) >> 1, read from the float's bits: the nearest to
/// log2(sqrt(texels)), clamped to the pyramid. Within a level, bilinear with 8-bit weights.
struct alignas(16) TriangleShading {
  float g1[3];
  float h1;
  float g2[3];
  float h2;
  float uv0[2];
  float duv1[2];
  float duv2[2];
  std::uint32_t color[3];  // of corners 0, 1, 2: R | G << 8 | B << 16, base colour multiplied in
  std::uint32_t texture;   // index into TexturePyramids::infos
  float normal[3];         // unit
  float plane;             // normal . corner
  float texel_density;     // (texels a metre at level 0) squared; 0 for a flat colour
  float glass;             // 1: glass or a mirror, 0: not
};
static_assert(sizeof(TriangleShading) == 96);

/// Where a texture's pyramid is: level m of a texture of side 2^k starts at texel
/// first + (4^(k+1) - 4^(k+1-m)) / 3.
struct TextureInfo {
  std::int32_t first = 0;
  std::int32_t log2_side = 0;
};

}  // namespace bulletnav::sim
