// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <variant>

#include "agent/slam/pose_graph/pose_graph.h"

namespace bulletnav::bench {

using AnyPoseGraph = std::variant<agent::PlanarPoseGraph, agent::SpatialPoseGraph>;

/// Reads a pose graph as g2o writes them, a line each:
///   VERTEX_SE2 id x y yaw                  EDGE_SE2 from to x y yaw I11 I12 I13 I22 I23 I33
///   VERTEX_SE3:QUAT id x y z qx qy qz qw   EDGE_SE3:QUAT from to x y z qx qy qz qw I11 ... I66
///   FIX id ...
/// Information is the upper triangle, row by row. In space g2o measures rotation by the x, y, z of
/// a quaternion, half an angle; what is read is information on angles. A line that joins other than
/// neighbours in the order of vertices is a loop. Quaternions of length 1 to within a hundredth are
/// normalised.
/// Throws sim::FileError with the line: unknown tags, both kinds in one file, what is not a finite
/// number, vertices that are unknown or there twice, and all that agent::Trouble finds.
/// Source: Kuemmerle et al., "g2o: a general framework for graph optimization", ICRA 2011.
AnyPoseGraph ReadG2o(const std::filesystem::path& file);

/// What ReadG2o reads, with all digits.
std::string ToG2o(const agent::PlanarPoseGraph& graph);
std::string ToG2o(const agent::SpatialPoseGraph& graph);

/// Atomically. Throws sim::FileError.
void WriteG2o(const std::filesystem::path& file, const AnyPoseGraph& graph);

}  // namespace bulletnav::bench
