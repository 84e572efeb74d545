// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "sim/image/image.h"

namespace bulletnav::sim {

/// Multiplier of a colour in display (sRGB-encoded) values; 255 leaves it as it is.
using Rgb8 = std::array<std::uint8_t, 3>;
inline constexpr Rgb8 kWhite = {255, 255, 255};

struct Texture {
  std::string name;
  Image image;  // RGBA; wraps around in both directions
};

/// Seen colour = base_color * texture (if any) * vertex colour, in display values; no light is
/// added.
struct Material {
  std::string name;
  Rgb8 base_color = kWhite;
  int texture = -1;  // index into SceneMesh::textures, -1 for none
};

/// Something that a mesh shows: a piece of furniture, a wall of a room, a door.
struct SceneObject {
  std::string category;  // "office_chair", "wall"; empty for what is not known
  std::string name;      // no other's in the scene: "office_chair_3"
  std::string room;      // "bedroom_2"; empty for what is in none

  bool operator==(const SceneObject&) const = default;
};

/// One indoor mesh in the world frame: metres, y up. Everything the other parts are made from:
/// physics, navmesh and renderers each take what they need and keep no reference.
/// Arrays of vertices have equal length, so do those of triangles; every triangle has a material;
/// every index is in range, every vertex finite (Validate checks).
struct SceneMesh {
  std::vector<Eigen::Vector3f> positions;
  std::vector<Eigen::Vector2f>
      uvs;                   // one a vertex; v down: (0, 0) is the picture's top left corner
  std::vector<Rgb8> colors;  // one a vertex
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::uint32_t> triangle_materials;  // one a triangle
  std::vector<Material> materials;                // at least one
  std::vector<Texture> textures;
  // What triangles belong to; both empty where nobody knows, as in most files of others.
  std::vector<SceneObject> objects;             // [0] is for what belongs to nothing known
  std::vector<std::uint32_t> triangle_objects;  // one a triangle, index into objects
  /// False: pictures leave out triangles seen from behind. In front, corners go anticlockwise.
  bool back_faces = true;
  /// True: the CPU's renderer makes coarse copies of fine parts and draws those far away.
  bool levels_of_detail = false;

  bool has_objects() const { return !triangle_objects.empty(); }

  /// Box around the vertices that triangles use; empty if there is no triangle.
  Eigen::AlignedBox3f Bounds() const;

  /// Throws Error, naming the first thing, if there are no triangles, arrays do not fit together,
  /// an index is out of range, a vertex not finite, or a texture without RGBA pixels.
  void Validate() const;
};

}  // namespace bulletnav::sim
