// SPDX-License-Identifier: MIT
#pragma once
#include "sim/house/materials.h"

namespace bulletnav::sim {

/// What the furniture of one room is made of, so that its pieces go together and rooms differ.
struct Palette {
  Surface wood;        // tables, frames, shelves
  Surface other_wood;  // a second one for contrast
  Surface metal;       // legs, handles, taps
  Surface fabric;      // upholstery
  Surface accent;      // cushions, throws, curtains
  Surface bedding;
  Surface cabinet;     // painted fronts
  Surface counter;     // worktops
  Surface ceramic;     // sanitary ware, crockery
  Surface rug;
  Surface shade;       // lamp shades, blinds
};

}  // namespace bulletnav::sim
