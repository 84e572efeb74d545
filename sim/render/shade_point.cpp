// SPDX-License-Identifier: MIT
#include "sim/render/shade_point.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace bulletnav::sim {
namespace {

float Channel(std::uint32_t packed, unsigned c) {
  return static_cast<float>((packed >> (8 * c)) & 255u);
}

/// Bilinear sample of one pyramid level; texture coordinates wrap.
std::array<float, 3> Sample(const TexturePyramids& textures, const TextureInfo& info, float u,
                            float v, int level) {
  const int log2_side = info.log2_side - level;
  const int side = 1 << log2_side;
  const int largest = 1 << info.log2_side;
  const auto first = static_cast<std::size_t>(info.first) +
                     4 *
                         (static_cast<std::size_t>(largest) * static_cast<std::size_t>(largest) -
                          static_cast<std::size_t>(side) * static_cast<std::size_t>(side)) /
                         3;
  const std::uint32_t* texels = &textures.texels[first];
  const float x = u * static_cast<float>(side) - 0.5f;
  const float y = v * static_cast<float>(side) - 0.5f;
  const int x0 = static_cast<int>(std::floor(x));
  const int y0 = static_cast<int>(std::floor(y));
  const float fx = x - static_cast<float>(x0);
  const float fy = y - static_cast<float>(y0);
  std::array<float, 3> sum{};
  for (int k = 0; k < 4; ++k) {
    const int column = (x0 + (k & 1)) & (side - 1);
    const int row = (y0 + (k >> 1)) & (side - 1);
    const float weight = ((k & 1) ? fx : 1.0f - fx) * ((k >> 1) ? fy : 1.0f - fy);
    const std::uint32_t texel = texels[(row << log2_side) + column];
    for (unsigned c = 0; c < 3; ++c) sum[c] += weight * Channel(texel, c);
  }
  return sum;
}

}  // namespace

Rgb8 ShadePoint(const RenderMesh& mesh, std::size_t triangle, const Eigen::Vector3f& point,
                float pixel_m2) {
  const TriangleShading& t = mesh.shading[triangle];
  const auto weight = [&](const float(&g)[3], float h) {
    return std::clamp(g[0] * point.x() + g[1] * point.y() + g[2] * point.z() + h, 0.0f, 1.0f);
  };
  const float b1 = weight(t.g1, t.h1);
  const float b2 = std::min(weight(t.g2, t.h2), 1.0f - b1);
  const TextureInfo& info = mesh.textures.infos[t.texture];
  const float texels = std::max(t.texel_density * pixel_m2, 1e-6f);
  // log2(texels) / 2, rounded.
  const int level = std::clamp((std::ilogb(texels) + 1) >> 1, 0, info.log2_side);
  const std::array<float, 3> texel =
      Sample(mesh.textures, info, t.uv0[0] + b1 * t.duv1[0] + b2 * t.duv2[0],
             t.uv0[1] + b1 * t.duv1[1] + b2 * t.duv2[1], level);
  Rgb8 rgb{};
  for (unsigned c = 0; c < 3; ++c) {
    const float c0 = Channel(t.color[0], c);
    const float color =
        c0 + b1 * (Channel(t.color[1], c) - c0) + b2 * (Channel(t.color[2], c) - c0);
    const float value = texel[c] * color / 255.0f;
    // As the kernels round.
    rgb[c] = static_cast<std::uint8_t>(value + 0.5f);  // NOLINT(bugprone-incorrect-roundings)
  }
  return rgb;
}

}  // namespace bulletnav::sim
