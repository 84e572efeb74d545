// SPDX-License-Identifier: MIT
#include "agent/models/free_space_model.h"

#include <gtest/gtest.h>

namespace bulletnav::agent {
namespace {

TEST(FreeSpace, CellsAndPlacesAgree) {
  for (int i = 0; i < FreeSpace::kSide * FreeSpace::kSide; ++i) {
    const sim::Cell cell{i % FreeSpace::kSide, i / FreeSpace::kSide};
    const FreeSpace::Place p = FreeSpace::CentreOf(cell);
    const bool is_near = std::hypot(p.x, p.y) < FreeSpace::kReach;
    EXPECT_EQ(FreeSpace::CellAt(p), is_near ? std::optional(cell) : std::nullopt);
  }
}

TEST(FreeSpace, LiesAroundTheBody) {
  EXPECT_EQ(FreeSpace::CellAt({0.01, 0.01}), sim::Cell(64, 64));
  EXPECT_EQ(FreeSpace::CellAt({-0.01, 0.01}), sim::Cell(63, 64));
  EXPECT_EQ(FreeSpace::CellAt({1.01, -0.51}), sim::Cell(84, 53));
  EXPECT_FALSE(FreeSpace::CellAt({3.21, 0.0}));
  EXPECT_FALSE(FreeSpace::CellAt({2.4, 2.4}));
}

}  // namespace
}  // namespace bulletnav::agent
