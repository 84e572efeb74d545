// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>

#include "agent/slam/pose_graph/pose_graph.h"

namespace bulletnav::agent {

/// What is wrong with a vertex or an edge by itself, and the remedy: numbers that are not finite
/// or too large to square, rotations that are none, an edge from a vertex to itself, information
/// that is not symmetric or not positive definite. Nothing if all is well.
template <class Pose>
std::optional<std::string> Trouble(const PoseVertex<Pose>& vertex);
template <class Pose>
std::optional<std::string> Trouble(const PoseEdge<Pose>& edge);

/// Finds the vertices of edges and the pieces they make.
/// Throws sim::Error, naming edge or vertex: no vertices at all, trouble as above, a number that
/// two vertices have or that an edge names and no vertex has.
template <class Pose>
PoseGraphLinks LinksOf(const PoseGraph<Pose>& graph);

/// Throws sim::Error if a graph is in more than one piece, naming the first vertex of the second.
template <class Pose>
void CheckOnePiece(const PoseGraph<Pose>& graph, const PoseGraphLinks& links);

}  // namespace bulletnav::agent
