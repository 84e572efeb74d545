// SPDX-License-Identifier: MIT
#include "sim/house/style/tint.h"

#include <gtest/gtest.h>

namespace bulletnav::sim::style {
namespace {

TEST(Hex, ReadsHtmlColors) {
  EXPECT_EQ(Hex(0x12AB00), (Rgb8{0x12, 0xAB, 0x00}));
}

TEST(Mix, RunsFromOneToTheOther) {
  EXPECT_EQ(Mix(Hex(0x000000), Hex(0xFF8040), 0.0), Hex(0x000000));
  EXPECT_EQ(Mix(Hex(0x000000), Hex(0xFF8040), 1.0), Hex(0xFF8040));
  EXPECT_EQ(Mix(Hex(0x000000), Hex(0xFF8040), 0.5), Hex(0x804020));
}

TEST(ColorDistance, HasTheUsualScale) {
  EXPECT_EQ(ColorDistance(kWhite, kWhite), 0.0);
  EXPECT_NEAR(ColorDistance(kWhite, Hex(0x000000)), 100.0, 0.1);
  // L*a*b* of pure sRGB red: 53.24, 80.09, 67.20; green: 87.73, -86.18, 83.18.
  EXPECT_NEAR(ColorDistance(Hex(0xFF0000), Hex(0x00FF00)), 170.6, 0.5);
  EXPECT_LT(ColorDistance(Hex(0x808080), Hex(0x828282)), 1.5);
}

}  // namespace
}  // namespace bulletnav::sim::style
