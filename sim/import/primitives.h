// SPDX-License-Identifier: MIT
#pragma once
#include "sim/scene/mesh.h"

namespace bulletnav::sim {

/// Shapes around the origin of one material, z their axis. Round ones have 32 sides.
SceneMesh BoxShape(const Eigen::Vector3f& size);
SceneMesh CylinderShape(float radius, float length);
SceneMesh EllipsoidShape(const Eigen::Vector3f& radii);
/// Level, at z = 0.
SceneMesh PlaneShape(const Eigen::Vector2f& size);

}  // namespace bulletnav::sim
