// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "sim/scene/mesh.h"

namespace bulletnav::sim {

/// Patches of surface that are missing, as scanners leave them on dark and shiny things.
struct Holes {
  double share = 0.0;   // of the area of all surfaces that may have holes
  double size = 0.4;    // metres from one hole to the next, about twice a hole's width
  bool floors = false;  // whether floors have holes, too

  template <class V>
  void Visit(V& v) {
    v("share", share);
    v("size", size);
    v("floors", floors);
  }
  void Validate() const;
  bool operator==(const Holes&) const = default;
};

/// Surfaces that are wavy, as meshes made from noisy depth are.
struct Bumps {
  double height = 0.0;  // metres that a point moves at most to each side; up and down .3 of it
  double size = 0.4;    // metres from bump to bump

  template <class V>
  void Visit(V& v) {
    v("height", height);
    v("size", size);
  }
  void Validate() const;
  bool operator==(const Bumps&) const = default;
};

/// Patches in which textures are smeared along a line, and colours of vertices washed out.
struct Smears {
  double share = 0.0;   // of each texture and of the vertices
  double length = 0.1;  // of a texture's side

  template <class V>
  void Visit(V& v) {
    v("share", share);
    v("length", length);
  }
  void Validate() const;
  bool operator==(const Smears&) const = default;
};

/// Patches of surface that are there twice, as where two scans were laid together badly.
struct Doubled {
  double share = 0.0;    // of all area
  double offset = 0.05;  // metres between the two, along the ground

  template <class V>
  void Visit(V& v) {
    v("share", share);
    v("offset", offset);
  }
  void Validate() const;
  bool operator==(const Doubled&) const = default;
};

/// What scanning, exporting and daily life do to a scene. Only what is drawn changes: bodies move
/// and ways lead through the scene as it was. Bumps and doubles are centimetres, clutter lies where
/// no body fits, and floors stay where they were. The default leaves a scene as it is.
struct Damage {
  /// Other damage for another seed.
  std::uint64_t seed = 0;
  /// Metres; 0: none. Corners of finely cut things that lie within one cell of this size become
  /// one.
  double low_poly = 0.0;
  /// Metres; 0: none. Textures go, and their colours stay at vertices so far apart: what is left of
  /// a scan that is kept without pictures.
  double color_spacing = 0.0;
  /// Boxes and stones of 5 to 40 cm lying about along walls and on tops, per 10 m2 of floor.
  double clutter = 0.0;
  Bumps bumps = {};
  Doubled doubled = {};
  Holes holes = {};
  Smears smears = {};
  /// Share of the floor through which a scanner saw what the floor reflects: gaps, and below them
  /// the room upside down.
  double mirrored = 0.0;

  template <class V>
  void Visit(V& v) {
    v("seed", seed);
    v("low_poly", low_poly);
    v("color_spacing", color_spacing);
    v("clutter", clutter);
    v("bumps", bumps);
    v("doubled", doubled);
    v("holes", holes);
    v("smears", smears);
    v("mirrored", mirrored);
  }
  /// Throws Error.
  void Validate() const;
  bool operator==(const Damage&) const = default;
};

/// Expects a mesh that SceneMesh::Validate accepts; the result is one, too. A function of the
/// arguments, the same bits on every processor. Cost: under a second for a house.
void ApplyDamage(const Damage& damage, SceneMesh* mesh);

}  // namespace bulletnav::sim
