// SPDX-License-Identifier: MIT
#include "agent/mapping/felt_edges.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace bulletnav::agent {
namespace {

/// The body is stopped so many times along an edge at x = 0.2, so far from stop to stop.
bool FeelAlong(FeltEdges* edges, int stops, double apart, double from = 0.0) {
  bool is_edge = false;
  for (int i = 0; i < stops; ++i) is_edge = edges->Feel({0.0, from + apart * i, 0.0});
  return is_edge;
}

/// Whether some segment comes within 3 cm of a point.
bool Covers(const FeltEdges& edges, const Point& p) {
  return std::any_of(edges.segments().begin(), edges.segments().end(),
                     [&](const FeltEdges::Segment& edge) {
                       for (int i = 0; i <= 100; ++i) {
                         const double t = 0.01 * i;
                         const Point at{edge.from.x + t * (edge.to.x - edge.from.x),
                                        edge.from.y + t * (edge.to.y - edge.from.y)};
                         if (Distance(at, p) < 0.03) return true;
                       }
                       return false;
                     });
}

TEST(FeltEdges, AFewStopsAreNoEdge) {
  FeltEdges edges;
  EXPECT_FALSE(FeelAlong(&edges, 7, 0.1));
  EXPECT_TRUE(edges.segments().empty());
  EXPECT_TRUE(FeelAlong(&edges, 1, 0.1, 0.7));
  EXPECT_FALSE(edges.segments().empty());
}

TEST(FeltEdges, StopsFarFromEachOtherAreNoEdge) {
  FeltEdges edges;
  EXPECT_FALSE(FeelAlong(&edges, 20, 0.5));
  EXPECT_TRUE(edges.segments().empty());
}

TEST(FeltEdges, WhatWasTouchedIsJoinedAndGoesOnALittle) {
  FeltEdges edges;
  FeelAlong(&edges, 8, 0.2);
  for (double y = -0.15; y < 1.55; y += 0.05) EXPECT_TRUE(Covers(edges, {0.2, y})) << y;
  EXPECT_FALSE(Covers(edges, {0.2, -0.3}));
  EXPECT_FALSE(Covers(edges, {0.2, 1.7}));
  EXPECT_FALSE(Covers(edges, {0.0, 0.7})) << "where the body is";
}

TEST(FeltEdges, WhatTheBodyMayFitThroughStaysOpen) {
  FeltEdges edges;
  FeelAlong(&edges, 8, 0.05);
  FeelAlong(&edges, 8, 0.05, 1.3);
  EXPECT_TRUE(Covers(edges, {0.2, 0.3}));
  EXPECT_TRUE(Covers(edges, {0.2, 1.4}));
  EXPECT_FALSE(Covers(edges, {0.2, 0.8}));
}

TEST(FeltEdges, PushingAtOnePlaceAddsLittle) {
  FeltEdges edges;
  FeelAlong(&edges, 400, 0.0);
  EXPECT_LE(edges.segments().size(), 400u);
  edges.Reset();
  EXPECT_TRUE(edges.segments().empty());
  EXPECT_FALSE(FeelAlong(&edges, 7, 0.1));
}

}  // namespace
}  // namespace bulletnav::agent
