// SPDX-License-Identifier: MIT
#include "sim/math/segment_triangle.h"

#include <gtest/gtest.h>

#include "sim/math/rng.h"

namespace bulletnav::sim {
namespace {

using Vec = Eigen::Vector3d;

Vec RandomPoint(Rng* rng) {
  return {rng->Uniform(-1, 1), rng->Uniform(-1, 1), rng->Uniform(-1, 1)};
}

/// Distance by trying many points of both: an upper bound that is near the truth.
double SampledDistance(const Vec& p0, const Vec& p1, const Triangle3d& t) {
  constexpr int kSteps = 40;
  double best = 1e9;
  for (int i = 0; i <= kSteps; ++i) {
    const Vec p = p0 + (p1 - p0) * i / kSteps;
    for (int j = 0; j <= kSteps; ++j) {
      for (int k = 0; j + k <= kSteps; ++k) {
        const Vec q = t[0] + (t[1] - t[0]) * j / kSteps + (t[2] - t[0]) * k / kSteps;
        best = std::min(best, (p - q).norm());
      }
    }
  }
  return best;
}

TEST(SegmentTriangle, DistanceAgreesWithSampling) {
  Rng rng(1, "segments");
  for (int i = 0; i < 60; ++i) {
    const Vec p0 = RandomPoint(&rng);
    const Vec p1 = RandomPoint(&rng);
    const Triangle3d t = {RandomPoint(&rng), RandomPoint(&rng), RandomPoint(&rng)};
    const double exact = SegmentToTriangle(p0, p1, t).distance;
    const double sampled = SampledDistance(p0, p1, t);
    EXPECT_LE(exact, sampled + 1e-9);
    EXPECT_GE(exact, sampled - 0.08);
  }
}

TEST(SegmentTriangle, CrossingMeansDistanceZero) {
  Rng rng(2, "segments");
  int crossings = 0;
  for (int i = 0; i < 500; ++i) {
    const Vec p0 = RandomPoint(&rng);
    const Vec p1 = RandomPoint(&rng);
    const Triangle3d t = {RandomPoint(&rng), RandomPoint(&rng), RandomPoint(&rng)};
    const bool crosses = SegmentCrossesTriangle(p0, p1, t);
    crossings += crosses ? 1 : 0;
    EXPECT_EQ(crosses, SegmentToTriangle(p0, p1, t).distance < 1e-9);
  }
  EXPECT_GT(crossings, 10);
}

TEST(SegmentTriangle, NearestPointsAreOnTheirShapesAndThatFarApart) {
  const Triangle3d t = {Vec(0, 0, 0), Vec(1, 0, 0), Vec(0, 1, 0)};
  const ClosestPoints above = PointToTriangle(Vec(0.2, 0.2, 3), t);
  EXPECT_TRUE(above.on_b.isApprox(Vec(0.2, 0.2, 0)));
  EXPECT_DOUBLE_EQ(above.distance, 3.0);
  const ClosestPoints beyond = PointToTriangle(Vec(2, 0, 0), t);
  EXPECT_TRUE(beyond.on_b.isApprox(Vec(1, 0, 0)));
  const ClosestPoints parallel =
      SegmentToSegment(Vec(0, 0, 1), Vec(1, 0, 1), Vec(0, 0, 0), Vec(1, 0, 0));
  EXPECT_DOUBLE_EQ(parallel.distance, 1.0);
}

TEST(SegmentTriangle, DegenerateShapesHaveDistancesToo) {
  const Triangle3d line = {Vec(0, 0, 0), Vec(1, 0, 0), Vec(2, 0, 0)};
  EXPECT_DOUBLE_EQ(PointToTriangle(Vec(1.5, 1, 0), line).distance, 1.0);
  const Triangle3d point = {Vec(1, 1, 1), Vec(1, 1, 1), Vec(1, 1, 1)};
  EXPECT_DOUBLE_EQ(SegmentToTriangle(Vec(1, 1, 3), Vec(1, 1, 5), point).distance, 2.0);
}

TEST(SegmentTriangle, TrianglesCross) {
  const Triangle3d flat = {Vec(0, 0, 0), Vec(2, 0, 0), Vec(0, 2, 0)};
  EXPECT_TRUE(TrianglesCross(flat, {Vec(0.2, 0.2, -1), Vec(0.2, 0.2, 1), Vec(3, 3, 0.5)}));
  EXPECT_FALSE(TrianglesCross(flat, {Vec(0, 0, 1), Vec(2, 0, 1), Vec(0, 2, 1)}));
  EXPECT_FALSE(TrianglesCross(flat, {Vec(3, 3, -1), Vec(3, 3, 1), Vec(4, 4, 0)}));
}

}  // namespace
}  // namespace bulletnav::sim
