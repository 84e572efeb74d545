// SPDX-License-Identifier: MIT
#include "sim/scene/glass.h"

#include <gtest/gtest.h>

namespace bulletnav::sim {
namespace {

TEST(Glass, IsKnownByItsName) {
  for (const char* name :
       {"glass", "Window_03", "BATHROOM MIRROR", "tv_screen", "FrostedGlass.001", "Glazing",
        "garden_view", "street_view", "Plexiglas", "frosted (see-through)", "(see-through)"}) {
    EXPECT_TRUE(IsGlass(name)) << name;
  }
  for (const char* name : {"", "default", "oak", "WindowFrame", "window_sill", "glass_fiber_board",
                           "Mirror_frame.002", "screen plastic", "window_blinds", "panel", "chrome",
                           "overview", "views", "projection_screen"}) {
    EXPECT_FALSE(IsGlass(name)) << name;
  }
}

TEST(Glass, ShinyIsMore) {
  for (const char* name : {"WindowFrame", "window", "Glass", "mirror_2", "tv_screen", "black_METAL",
                           "brushed_steel", "Chrome"}) {
    EXPECT_TRUE(IsShiny(name)) << name;
  }
  for (const char* name : {"", "oak", "garden_view", "panel", "frosted (see-through)"}) {
    EXPECT_FALSE(IsShiny(name)) << name;
  }
}

TEST(Glass, IsMarkedWhereLightGoesThrough) {
  for (const double opacity : {0.05, 0.3, 0.75}) EXPECT_TRUE(IsSeeThrough(opacity)) << opacity;
  for (const double opacity : {0.0, 0.9, 1.0}) EXPECT_FALSE(IsSeeThrough(opacity)) << opacity;
  Material material;
  material.name = "Material.003";
  MarkSeeThrough(&material);
  EXPECT_EQ(material.name, "Material.003 (see-through)");
  MarkSeeThrough(&material);
  EXPECT_EQ(material.name, "Material.003 (see-through)");
  EXPECT_TRUE(IsGlass(material.name));
  material.name.clear();
  MarkSeeThrough(&material);
  EXPECT_EQ(material.name, "(see-through)");
}

}  // namespace
}  // namespace bulletnav::sim
