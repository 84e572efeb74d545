// SPDX-License-Identifier: MIT
#pragma once
#include <array>

#include <Eigen/Core>

namespace bulletnav::sim {

using Triangle3d = std::array<Eigen::Vector3d, 3>;

/// A point of each of two shapes, as near to each other as any.
struct ClosestPoints {
  Eigen::Vector3d on_a;
  Eigen::Vector3d on_b;
  double distance = 0.0;
};

/// Nearest point of a triangle (b) to a point (a). A triangle without area counts as its edges.
ClosestPoints PointToTriangle(const Eigen::Vector3d& p, const Triangle3d& triangle);

/// Nearest points of two segments p0-p1 (a) and q0-q1 (b); either may be a point.
ClosestPoints SegmentToSegment(const Eigen::Vector3d& p0, const Eigen::Vector3d& p1,
                               const Eigen::Vector3d& q0, const Eigen::Vector3d& q1);

/// Nearest points of a segment (a) and a triangle (b); distance 0 where they cross.
ClosestPoints SegmentToTriangle(const Eigen::Vector3d& p0, const Eigen::Vector3d& p1,
                                const Triangle3d& triangle);

/// Whether a segment meets a triangle, its rim included; one that lies in the plane does not.
bool SegmentCrossesTriangle(const Eigen::Vector3d& p0, const Eigen::Vector3d& p1,
                            const Triangle3d& triangle);

/// Whether two triangles cut each other, other than lying in one plane.
bool TrianglesCross(const Triangle3d& a, const Triangle3d& b);

}  // namespace bulletnav::sim
