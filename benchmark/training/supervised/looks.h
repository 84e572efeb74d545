// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>

#include "sim/scene/finish.h"

namespace bulletnav::bench {

/// How the looks of training scenes are varied, so that those of scenes from elsewhere lie within
/// their range: see sim::Finish. Each scene has one look for the whole training.
struct LooksSpec {
  double share = 0.6;       // of scenes that do not look as their files say
  double no_ceiling = 0.4;  // of those: shares that differ in this, each drawn by itself
  double blank_floor = 0.3;
  double flat = 0.2;           // materials by their mean colours
  double vertex_colors = 0.2;  // colours of vertices alone
  double unlit = 0.3;
  double shrunk = 0.3;      // textures of few pixels
  double exposure = 0.5;    // factor of 1 - this to 1 + this
  double contrast = 0.4;    // likewise
  double saturation = 0.8;  // 1 - this to 1 + half of this
  double tint = 0.15;       // likewise, each channel by itself
  // Shares of the scenes that do not look as their files say, each drawn by itself; sim::Repaint
  // and sim::Damage.
  double recolored = 0.0;       // 0.3 to 1 of the materials
  double exchanged = 0.0;       // 0.2 to 0.8 of the textures
  double white = 0.0;           // all white, half with a grey floor; not flat or vertex_colors
  double blank_walls = 0.0;     // white walls
  double black_overhead = 0.0;  // of those with a ceiling
  double low_poly = 0.0;        // cells of 0.06 to 0.25 m
  double color_spacing = 0.0;   // colours at vertices 0.06 to 0.2 m apart
  double clutter = 0.0;         // 1 to 8 pieces per 10 m2
  double bumps = 0.0;           // of 0.5 to 5 cm, 0.15 to 1 m apart
  double doubled = 0.0;         // 0.02 to 0.25 of all area, 2 to 8 cm off
  double holes = 0.0;           // 0.01 to 0.15 of all area, 0.15 to 1.5 m apart; half with floors
  double smears = 0.0;          // 0.1 to 0.6, of 0.02 to 0.3 sides
  double mirrored = 0.0;        // 0.05 to 0.5 of the floor

  template <class V>
  void Visit(V& v) {
    v("share", share);
    v("no_ceiling", no_ceiling);
    v("blank_floor", blank_floor);
    v("flat", flat);
    v("vertex_colors", vertex_colors);
    v("unlit", unlit);
    v("shrunk", shrunk);
    v("exposure", exposure);
    v("contrast", contrast);
    v("saturation", saturation);
    v("tint", tint);
    v("recolored", recolored);
    v("exchanged", exchanged);
    v("white", white);
    v("blank_walls", blank_walls);
    v("black_overhead", black_overhead);
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
};

/// The look of a scene, a function of the arguments.
sim::Finish DrawLook(const LooksSpec& spec, std::uint64_t seed, const std::string& scene);

}  // namespace bulletnav::bench
