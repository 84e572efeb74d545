// SPDX-License-Identifier: MIT
#include "sim/render/render_mesh.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include <Eigen/Geometry>

#include "sim/base/check.h"
#include "sim/scene/glass.h"

namespace bulletnav::sim {
namespace {

constexpr int kMaxTextureSide = 2048;

int PowerOfTwoSide(const Image& image) {
  const auto larger = static_cast<unsigned>(std::max(image.width, image.height));
  const auto above = static_cast<int>(std::bit_ceil(larger));
  const bool below_is_nearer = 3 * above > 4 * static_cast<int>(larger);
  return std::min(kMaxTextureSide, below_is_nearer && above > 1 ? above / 2 : above);
}

void AddTexture(const Image& image, TexturePyramids* out) {
  const int side = PowerOfTwoSide(image);
  TextureInfo info;
  info.first = static_cast<std::int32_t>(out->texels.size());
  info.log2_side = std::countr_zero(static_cast<unsigned>(side));
  out->infos.push_back(info);
  Image level = Resize(image, side, side);
  while (true) {
    for (std::size_t i = 0; i < level.pixels.size(); i += 4) {
      const std::uint8_t* p = &level.pixels[i];
      out->texels.push_back(p[0] | (std::uint32_t{p[1]} << 8) | (std::uint32_t{p[2]} << 16) |
                            (std::uint32_t{p[3]} << 24));
    }
    if (level.width == 1) break;
    level = Resize(level, level.width / 2, level.width / 2);
  }
  BULLETNAV_CHECK_LT(out->texels.size(), std::size_t{1} << 30);
}

std::uint32_t PackColor(const Rgb8& a, const Rgb8& b) {
  std::uint32_t packed = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    packed |= ((std::uint32_t{a[c]} * b[c] + 127) / 255) << (8 * c);
  }
  return packed;
}

/// Makes the barycentric planes of a triangle with edges `u` and `v` from corner `a`, in double:
/// the weights of a sliver's corners change quickly.
void FillPlanes(const std::array<Eigen::Vector3f, 3>& corner, TriangleShading* out) {
  const Eigen::Vector3d a = corner[0].cast<double>();
  const Eigen::Vector3d u = corner[1].cast<double>() - a;
  const Eigen::Vector3d v = corner[2].cast<double>() - a;
  const Eigen::Vector3d n = u.cross(v);
  const double squared = n.squaredNorm();
  const Eigen::Vector3d g1 = v.cross(n) / squared;
  const Eigen::Vector3d g2 = n.cross(u) / squared;
  const Eigen::Vector3d unit = n / std::sqrt(squared);
  for (int i = 0; i < 3; ++i) {
    out->g1[i] = static_cast<float>(g1[i]);
    out->g2[i] = static_cast<float>(g2[i]);
    out->normal[i] = static_cast<float>(unit[i]);
  }
  out->h1 = static_cast<float>(-g1.dot(a));
  out->h2 = static_cast<float>(-g2.dot(a));
  out->plane = static_cast<float>(unit.dot(a));
}

void FillUvs(const std::array<Eigen::Vector2f, 3>& uv, double side, double area,
             TriangleShading* out) {
  // Whole turns of the texture do not show; near zero they cost the least precision.
  const Eigen::Vector2f whole(std::floor(uv[0].x()), std::floor(uv[0].y()));
  const Eigen::Vector2f d1 = uv[1] - uv[0];
  const Eigen::Vector2f d2 = uv[2] - uv[0];
  for (int i = 0; i < 2; ++i) {
    out->uv0[i] = uv[0][i] - whole[i];
    out->duv1[i] = d1[i];
    out->duv2[i] = d2[i];
  }
  const double uv_area = 0.5 * std::abs(double{d1.x()} * d2.y() - double{d1.y()} * d2.x());
  out->texel_density = static_cast<float>(std::min(1e12, uv_area * side * side / area));
}

}  // namespace

RenderMesh::RenderMesh(const SceneMesh& mesh) : back_faces(mesh.back_faces) {
  textures.infos.push_back({0, 0});
  textures.texels.push_back(0xffffffffu);
  for (const Texture& texture : mesh.textures) AddTexture(texture.image, &textures);
  for (const Material& material : mesh.materials) {
    glass_materials.push_back(IsGlass(material.name) ? 1 : 0);
  }
  corners.reserve(mesh.triangles.size());
  shading.reserve(mesh.triangles.size());
  if (mesh.has_objects()) objects.reserve(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) Add(mesh, mesh.triangles[t], t);
}

void RenderMesh::Add(const SceneMesh& mesh, const std::array<std::uint32_t, 3>& vertices,
                     std::size_t like) {
  const auto& [a, b, c] = vertices;
  const Material& material = mesh.materials[mesh.triangle_materials[like]];
  corners.push_back({mesh.positions[a], mesh.positions[b], mesh.positions[c]});
  TriangleShading& out = shading.emplace_back();
  FillPlanes(corners.back(), &out);
  out.color[0] = PackColor(material.base_color, mesh.colors[a]);
  out.color[1] = PackColor(material.base_color, mesh.colors[b]);
  out.color[2] = PackColor(material.base_color, mesh.colors[c]);
  out.texture = static_cast<std::uint32_t>(material.texture + 1);
  const double side = std::exp2(textures.infos[out.texture].log2_side);
  const auto& p = corners.back();
  const double area = 0.5 * (p[1] - p[0]).cross(p[2] - p[0]).norm();
  FillUvs({mesh.uvs[a], mesh.uvs[b], mesh.uvs[c]}, side, area, &out);
  if (glass_materials[mesh.triangle_materials[like]] != 0) {
    out.glass = 1.0f;
    has_glass = true;
  }
  if (mesh.has_objects()) objects.push_back(mesh.triangle_objects[like]);
}

}  // namespace bulletnav::sim
