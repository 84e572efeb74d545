// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "sim/scene/mesh.h"

namespace bulletnav::tests {

/// Closed room, inner faces at x in [0, width], y in [0, height], z in [-depth, 0]; every wall has
/// its own flat colour. Depth along any ray is known in closed form.
sim::SceneMesh BoxRoom(float width, float height, float depth);

/// L-shaped corridor of one width without ceiling: from (0, 0) along +x to x = a, and from there
/// along -z to z = -b; walls all around. Geodesics bend around the one inner corner (a - width,
/// -width).
sim::SceneMesh LCorridor(float a, float b, float width, float height);

/// Appends the 12 triangles of a box; faces outwards.
void AddBox(const Eigen::Vector3f& low, const Eigen::Vector3f& high, const sim::Rgb8& color,
            sim::SceneMesh* mesh);

/// Appends a quad a, b, c, d.
void AddQuad(const Eigen::Vector3f& a, const Eigen::Vector3f& b, const Eigen::Vector3f& c,
             const Eigen::Vector3f& d, const sim::Rgb8& color, sim::SceneMesh* mesh);

/// The file scene.obj of a real scene made by others, from $BULLETNAV_SCENES or the folder
/// ../shared/scenes beside the project; tests skip themselves, visibly, where it is absent.
std::optional<std::filesystem::path> SharedScene(const std::string& name);

}  // namespace bulletnav::tests
