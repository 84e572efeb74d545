// SPDX-License-Identifier: MIT
#pragma once
#include "sim/house/materials.h"

namespace bulletnav::sim {

/// How doors and drawers are opened, the same all over a room.
enum class Handles { kBar, kKnob, kNone };

/// What the furniture of one room is made of, so that its pieces go together and rooms differ.
struct Palette {
  Surface wood;          // tables, frames, shelves
  Surface other_wood;    // a second one for contrast
  Surface metal;         // legs, handles, taps
  Surface fabric;        // upholstery
  Surface accent;        // cushions, throws, curtains
  Surface other_accent;  // the second colour of small things
  Surface bedding;
  Surface cabinet;     // painted fronts
  Surface counter;     // worktops
  Surface backsplash;  // the wall above worktops
  Surface appliance;   // refrigerators, ovens, washing machines
  Surface ceramic;     // sanitary ware, crockery
  Surface rug;
  Surface shade;  // lamp shades, blinds
  Handles handles = Handles::kBar;
  bool framed_fronts = false;  // panelled doors instead of flat ones
};

}  // namespace bulletnav::sim
