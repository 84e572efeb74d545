// SPDX-License-Identifier: MIT
#include "sim/math/segment_triangle.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace bulletnav::sim {
namespace {

using Vec = Eigen::Vector3d;

ClosestPoints Between(const Vec& a, const Vec& b) {
  return {a, b, (a - b).norm()};
}

void KeepNearer(const ClosestPoints& candidate, ClosestPoints* best) {
  if (candidate.distance < best->distance) *best = candidate;
}

/// Barycentric weights of corners 1 and 2 of p's projection; false if the triangle has no area.
bool Barycentric(const Vec& p, const Triangle3d& t, double* b1, double* b2) {
  const Vec u = t[1] - t[0];
  const Vec v = t[2] - t[0];
  const Vec n = u.cross(v);
  const double squared = n.squaredNorm();
  if (squared <= 0.0) return false;
  const Vec w = p - t[0];
  *b1 = w.cross(v).dot(n) / squared;
  *b2 = u.cross(w).dot(n) / squared;
  return true;
}

}  // namespace

ClosestPoints SegmentToSegment(const Vec& p0, const Vec& p1, const Vec& q0, const Vec& q1) {
  const Vec d1 = p1 - p0;
  const Vec d2 = q1 - q0;
  const Vec r = p0 - q0;
  const double a = d1.squaredNorm();
  const double e = d2.squaredNorm();
  const double f = d2.dot(r);
  const double c = d1.dot(r);
  const double b = d1.dot(d2);
  const double denominator = a * e - b * b;
  // Nearest point of the first line to the second, then clamp in turn.
  double s = 0.0;
  if (a > 0.0) {
    s = denominator > 1e-14 * a * e ? std::clamp((b * f - c * e) / denominator, 0.0, 1.0) : 0.0;
  }
  double t = e > 0.0 ? (b * s + f) / e : 0.0;
  if (t < 0.0 || t > 1.0 || e <= 0.0) {
    t = std::clamp(t, 0.0, 1.0);
    s = a > 0.0 ? std::clamp((b * t - c) / a, 0.0, 1.0) : 0.0;
  }
  return Between(p0 + s * d1, q0 + t * d2);
}

ClosestPoints PointToTriangle(const Vec& p, const Triangle3d& triangle) {
  double b1 = 0.0;
  double b2 = 0.0;
  if (Barycentric(p, triangle, &b1, &b2) && b1 >= 0.0 && b2 >= 0.0 && b1 + b2 <= 1.0) {
    return Between(
        p, triangle[0] + b1 * (triangle[1] - triangle[0]) + b2 * (triangle[2] - triangle[0]));
  }
  ClosestPoints best = SegmentToSegment(p, p, triangle[0], triangle[1]);
  KeepNearer(SegmentToSegment(p, p, triangle[1], triangle[2]), &best);
  KeepNearer(SegmentToSegment(p, p, triangle[2], triangle[0]), &best);
  return best;
}

bool SegmentCrossesTriangle(const Vec& p0, const Vec& p1, const Triangle3d& triangle) {
  const Vec n = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
  const double h0 = n.dot(p0 - triangle[0]);
  const double h1 = n.dot(p1 - triangle[0]);
  const bool on_one_side = (h0 > 0.0 && h1 > 0.0) || (h0 < 0.0 && h1 < 0.0);
  if (h0 == h1 || on_one_side) return false;
  const Vec at = p0 + (h0 / (h0 - h1)) * (p1 - p0);
  double b1 = 0.0;
  double b2 = 0.0;
  if (!Barycentric(at, triangle, &b1, &b2)) return false;
  return b1 >= 0.0 && b2 >= 0.0 && b1 + b2 <= 1.0;
}

ClosestPoints SegmentToTriangle(const Vec& p0, const Vec& p1, const Triangle3d& triangle) {
  ClosestPoints best = PointToTriangle(p0, triangle);
  KeepNearer(PointToTriangle(p1, triangle), &best);
  for (std::size_t i = 0; i < 3; ++i) {
    KeepNearer(SegmentToSegment(p0, p1, triangle[i], triangle[(i + 1) % 3]), &best);
  }
  if (best.distance > 0.0 && SegmentCrossesTriangle(p0, p1, triangle)) {
    const Vec n = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
    const double h0 = n.dot(p0 - triangle[0]);
    const double h1 = n.dot(p1 - triangle[0]);
    const Vec at = p0 + (h0 / (h0 - h1)) * (p1 - p0);
    best = {at, at, 0.0};
  }
  return best;
}

bool TrianglesCross(const Triangle3d& a, const Triangle3d& b) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (SegmentCrossesTriangle(a[i], a[(i + 1) % 3], b)) return true;
    if (SegmentCrossesTriangle(b[i], b[(i + 1) % 3], a)) return true;
  }
  return false;
}

}  // namespace bulletnav::sim
