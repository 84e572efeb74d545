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
  }
  /// Throws Error.
  void Validate() const;
};

/// The look of a scene, a function of the arguments.
sim::Finish DrawLook(const LooksSpec& spec, std::uint64_t seed, const std::string& scene);

}  // namespace bulletnav::bench
