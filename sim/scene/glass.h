// SPDX-License-Identifier: MIT
#pragma once
#include <string_view>

#include "sim/scene/mesh.h"

namespace bulletnav::sim {

/// Whether a material's name tells of something that shines: window, glass, mirror, screen, metal,
/// steel or chrome is in it, in any case.
bool IsShiny(std::string_view material);

/// Whether a material's name tells of glass or a mirror: window, glass, glazing, plexi, mirror or
/// screen is in it, in any case, and nothing that windows and screens have besides (frame, sill,
/// blind, wood, metal...); or MarkSeeThrough has been there; or it is one of the pictures behind
/// the windows of generated houses ("garden_view").
bool IsGlass(std::string_view material);

/// Whether a surface of this opacity is one that light goes through: neither nearly opaque, nor so
/// clear that it could not be seen, which is an exporter's mistake.
bool IsSeeThrough(double opacity);

/// Notes in a material's name that light goes through it: pictures are drawn opaque, and a Material
/// has no opacity. Export keeps the note.
void MarkSeeThrough(Material* material);

}  // namespace bulletnav::sim
