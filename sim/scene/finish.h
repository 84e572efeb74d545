// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <utility>

#include "sim/config/enum_names.h"
#include "sim/scene/damage.h"
#include "sim/scene/mesh.h"
#include "sim/scene/repaint.h"

namespace bulletnav::sim {

/// What surfaces are coloured by.
enum class Surfaces {
  kOriginal,
  kFlat,          // each material by the mean colour of its texture
  kVertexColors,  // by the vertices alone: what is left of a scan without its pictures
  kAllWhite  // not at all: white but for a blank floor, with the light of the vertices' colours
};

template <>
struct EnumNames<Surfaces> {
  static constexpr std::array kNames = {
      std::pair{"original", Surfaces::kOriginal}, std::pair{"flat", Surfaces::kFlat},
      std::pair{"vertex_colors", Surfaces::kVertexColors}, std::pair{"white", Surfaces::kAllWhite}};
};

/// How a scene looks, beside what its file says: scenes differ in this more than in their rooms.
/// Some have no ceiling, no pictures on their surfaces, no light; networks are trained on all.
/// Colours change in display (sRGB-encoded) values, those of vertices where a scene has no others.
/// The default leaves a scene as it is.
struct Finish {
  /// False: level faces more than 2 m above the floor are left out, so that nothing is overhead.
  bool ceiling = true;
  /// True: they are nearly black.
  bool black_overhead = false;
  Surfaces surfaces = Surfaces::kOriginal;
  /// Before anything else.
  Repaint repaint = {};
  /// One grey for all that is level and lies on the floor's height.
  bool blank_floor = false;
  /// White walls: materials of upright faces alone, from below 0.5 m to above 2.2 m, 5 m2 or more.
  bool blank_walls = false;
  /// False: colours of vertices, into which light is baked, are white.
  bool baked_light = true;
  /// Pixels of a texture that become one, to a side: 16 leaves little but its colours.
  int texture_shrink = 1;
  double exposure = 1.0;                         // factor of all colours
  double contrast = 1.0;                         // around middle grey
  double saturation = 1.0;                       // 0: grey
  std::array<double, 3> tint = {1.0, 1.0, 1.0};  // factors of red, green, blue
  /// False: triangles seen from behind are not drawn. For scenes whose windings can be trusted.
  bool back_faces = true;
  /// True: what is far is drawn with fewer triangles, wrong by less than half a pixel (embree).
  bool levels_of_detail = false;
  /// Of what is drawn; see ImportedScene::drawn.
  Damage damage = {};

  template <class V>
  void Visit(V& v) {
    v("ceiling", ceiling);
    v("black_overhead", black_overhead);
    v("surfaces", surfaces);
    v("repaint", repaint);
    v("blank_floor", blank_floor);
    v("blank_walls", blank_walls);
    v("baked_light", baked_light);
    v("texture_shrink", texture_shrink);
    v("exposure", exposure);
    v("contrast", contrast);
    v("saturation", saturation);
    v("tint", tint);
    v("back_faces", back_faces);
    v("levels_of_detail", levels_of_detail);
    v("damage", damage);
  }
  /// Throws Error.
  void Validate() const;
  bool operator==(const Finish&) const = default;
};

/// All of a finish but its damage, see ApplyDamage. Expects a mesh that SceneMesh::Validate
/// accepts; the result is one, too. If all triangles would be left out with the ceiling, they stay.
/// The same bits on every processor.
void ApplyFinish(const Finish& finish, SceneMesh* mesh);

}  // namespace bulletnav::sim
