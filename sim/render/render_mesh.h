// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "sim/render/triangle_shading.h"
#include "sim/scene/mesh.h"

namespace bulletnav::sim {

/// All textures as square powers of two with their half-size levels, in one array of RGBA texels.
struct TexturePyramids {
  std::vector<std::uint32_t> texels;
  std::vector<TextureInfo> infos;  // [0] is a single white texel, for triangles without a texture
};

/// A SceneMesh as renderers want it: triangles that share nothing, shading made ready.
struct RenderMesh {
  explicit RenderMesh(const SceneMesh& mesh);

  /// Adds a triangle between three vertices of the mesh that this was made of, with the material
  /// and object of its triangle `like`.
  void Add(const SceneMesh& mesh, const std::array<std::uint32_t, 3>& vertices, std::size_t like);

  std::vector<std::array<Eigen::Vector3f, 3>> corners;
  std::vector<TriangleShading> shading;
  TexturePyramids textures;
  std::vector<std::uint32_t> objects;  // one a triangle; empty where they are not known
  std::vector<char> glass_materials;   // of the mesh: whether it is glass or a mirror
  bool has_glass = false;              // in any triangle
  bool back_faces;                     // whether triangles are seen from behind
};

}  // namespace bulletnav::sim
