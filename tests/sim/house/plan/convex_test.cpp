// SPDX-License-Identifier: MIT
#include "sim/house/plan/convex.h"

#include <gtest/gtest.h>

namespace bulletnav::sim::plan {
namespace {

const Quad kSquare = {PlanPoint(0, 0), PlanPoint(1, 0), PlanPoint(1, 1), PlanPoint(0, 1)};

Quad Moved(const Quad& quad, float dx, float dy) {
  Quad moved = quad;
  for (PlanPoint& p : moved) p += PlanPoint(dx, dy);
  return moved;
}

TEST(AreClose, MeasuresTheGapBetweenSides) {
  EXPECT_TRUE(AreClose(kSquare, Moved(kSquare, 0.9f, 0.0f), 0.0f));
  EXPECT_FALSE(AreClose(kSquare, Moved(kSquare, 1.1f, 0.0f), 0.05f));
  EXPECT_TRUE(AreClose(kSquare, Moved(kSquare, 1.1f, 0.0f), 0.2f));
  EXPECT_FALSE(AreClose(kSquare, Moved(kSquare, 0.0f, -1.1f), 0.05f));
}

TEST(AreClose, SeesADiamondPastACorner) {
  const Quad diamond = {PlanPoint(1.5f, 0.9f), PlanPoint(2.1f, 1.5f), PlanPoint(1.5f, 2.1f),
                        PlanPoint(0.9f, 1.5f)};
  EXPECT_FALSE(AreClose(kSquare, diamond, 0.0f));
  EXPECT_TRUE(AreClose(Moved(kSquare, 0.3f, 0.3f), diamond, 0.0f));
}

TEST(ApproachZone, ReachesBeyondBothFaces) {
  Opening arch;
  arch.a = {2, 0};
  arch.b = {2, 1};
  arch.wall_thickness = 0.2f;
  const Quad zone = ApproachZone(arch, 0.4f);
  EXPECT_FLOAT_EQ(PolygonArea(zone), 1.0f);
  EXPECT_TRUE(IsInside(zone, {2.45f, 0.5f}));
  EXPECT_TRUE(IsInside(zone, {1.55f, 0.5f}));
  EXPECT_FALSE(IsInside(zone, {2.0f, 1.1f}));
}

}  // namespace
}  // namespace bulletnav::sim::plan
