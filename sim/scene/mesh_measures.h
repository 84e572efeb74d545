// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "sim/scene/mesh.h"

namespace bulletnav::sim {

/// Twice the area times the unit normal.
Eigen::Vector3f NormalOf(const SceneMesh& mesh, std::size_t triangle);
Eigen::Vector3f CentreOf(const SceneMesh& mesh, std::size_t triangle);
/// m2.
double AreaOf(const SceneMesh& mesh, std::size_t triangle);
/// Within 25 degrees of level, whichever side is up.
bool IsLevel(const SceneMesh& mesh, std::size_t triangle);
/// Height of the lowest corner, of the highest one; metres.
float LowestOf(const SceneMesh& mesh, std::size_t triangle);
float HighestOf(const SceneMesh& mesh, std::size_t triangle);

/// The lowest height at which at least half as much area faces up as where most does: the floor, of
/// the lowest storey, also below a ceiling or a roof that faces up. Metres.
float FloorHeight(const SceneMesh& mesh);
/// Whether a triangle is level and at the floor's height, within 15 cm.
bool IsOnTheFloor(const SceneMesh& mesh, std::size_t triangle, float floor);

/// Mean height of the triangles on the floor; `floor` if there are none.
float ExactFloor(const SceneMesh& mesh, float floor);

/// Mean colour of a picture's pixels, red, green, blue; 0 to 255.
std::array<double, 3> MeanOf(const Image& image);
/// What is seen of a material on the whole, without its vertices' colours.
std::array<double, 3> MeanOf(const SceneMesh& mesh, const Material& material);

/// Appends a vertex with the attributes of another one.
std::uint32_t CopyVertex(std::uint32_t vertex, SceneMesh* mesh);
/// Appends a triangle of the material and the object of another one.
void AddTriangleLike(std::size_t triangle, const std::array<std::uint32_t, 3>& corners,
                     SceneMesh* mesh);
/// Leaves only those triangles that are marked.
void KeepTriangles(const std::vector<char>& kept, SceneMesh* mesh);

}  // namespace bulletnav::sim
