// SPDX-License-Identifier: MIT
#include "agent/slam/pose_graph/elimination_order.h"

#include <algorithm>
#include <numeric>
#include <set>

#include <gtest/gtest.h>

#include "sim/math/rng.h"

namespace bulletnav::agent {
namespace {

using Edges = std::vector<std::pair<int, int>>;

/// The streets of a town: a vertex a crossing, row after row.
Edges GridEdges(int side) {
  Edges edges;
  for (int i = 0; i < side * side; ++i) {
    if (i % side + 1 < side) edges.emplace_back(i, i + 1);
    if (i + side < side * side) edges.emplace_back(i + side, i);
  }
  return edges;
}

/// Entries below the diagonal of the Cholesky factor, by eliminating one vertex after the other.
std::size_t FactorEntries(int vertices, const Edges& edges, const std::vector<int>& order) {
  std::vector<std::set<int>> near(static_cast<std::size_t>(vertices));
  const auto join = [&](int a, int b) {
    near[static_cast<std::size_t>(a)].insert(b);
    near[static_cast<std::size_t>(b)].insert(a);
  };
  for (const auto& [from, to] : edges) join(from, to);
  std::size_t entries = 0;
  for (const int vertex : order) {
    const std::set<int> rest = std::move(near[static_cast<std::size_t>(vertex)]);
    entries += rest.size();
    for (const int a : rest) {
      near[static_cast<std::size_t>(a)].erase(vertex);
      for (const int b : rest) {
        if (a < b) join(a, b);
      }
    }
  }
  return entries;
}

std::vector<int> Natural(int vertices) {
  std::vector<int> order(static_cast<std::size_t>(vertices));
  std::iota(order.begin(), order.end(), 0);
  return order;
}

TEST(EliminationOrder, HasEachVertexOnceWhateverTheGraph) {
  sim::Rng rng(1, "edges");
  for (int i = 0; i < 50; ++i) {
    const int vertices = rng.Between(1, 400);
    Edges edges;
    for (int edge = rng.Between(0, 3 * vertices); edge > 0; --edge) {
      edges.emplace_back(rng.Below(vertices), rng.Below(vertices));  // twice, and loops, too
    }
    std::vector<int> order = EliminationOrder(vertices, edges);
    EXPECT_EQ(EliminationOrder(vertices, edges), order);
    std::sort(order.begin(), order.end());
    EXPECT_EQ(order, Natural(vertices));
  }
}

TEST(EliminationOrder, KeepsTheFactorOfATownSparse) {
  constexpr int kSide = 40;
  constexpr int kVertices = kSide * kSide;
  const Edges edges = GridEdges(kSide);
  const std::size_t natural = FactorEntries(kVertices, edges, Natural(kVertices));
  const std::size_t dissected = FactorEntries(kVertices, edges, EliminationOrder(kVertices, edges));
  EXPECT_LT(2 * dissected, natural);
}

TEST(EliminationOrder, OfAWalkThatMeetsNothingAddsNothing) {
  constexpr int kVertices = 500;
  Edges edges;
  for (int i = 1; i < kVertices; ++i) edges.emplace_back(i - 1, i);
  const std::size_t entries = FactorEntries(kVertices, edges, EliminationOrder(kVertices, edges));
  EXPECT_LT(entries, 2U * kVertices);
}

TEST(EliminationOrder, OfNothingIsNothing) {
  EXPECT_TRUE(EliminationOrder(0, {}).empty());
}

}  // namespace
}  // namespace bulletnav::agent
