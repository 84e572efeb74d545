// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <functional>

#include <Eigen/Core>

#include "sim/scene/mesh.h"

namespace bulletnav::sim {

/// Whether an edge between two points is halved, of a triangle with a material. Must not depend on
/// the order of the points, so that triangles that share an edge agree.
using SplitsEdge =
    std::function<bool(std::uint32_t material, const Eigen::Vector3f&, const Eigen::Vector3f&)>;

/// Cuts triangles at the middles of edges, again and again, until none is to be halved: at most 12
/// times and no more once there are two million triangles. What is seen stays as it is.
void Refine(const SplitsEdge& splits, SceneMesh* mesh);

/// The length of edges that gives a mesh about 120,000 triangles, beside those that are small
/// already: trainings keep hundreds of scenes in memory. Metres.
double AffordableEdge(const SceneMesh& mesh);

/// Refine, until no edge is longer than `longest`, or than AffordableEdge if that is more. Metres.
void RefineTo(double longest, SceneMesh* mesh);

/// m2 of all triangles.
double AreaOf(const SceneMesh& mesh);

}  // namespace bulletnav::sim
