// SPDX-License-Identifier: MIT
#pragma once
#include "sim/render/render_mesh.h"

namespace bulletnav::sim {

/// Colour of a triangle at a point on it, as the panorama renderers would show it from where a
/// pixel covers `pixel_m2` of it: one pixel at a time, for maps and baking.
Rgb8 ShadePoint(const RenderMesh& mesh, std::size_t triangle, const Eigen::Vector3f& point,
                float pixel_m2);

}  // namespace bulletnav::sim
