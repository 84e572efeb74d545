// SPDX-License-Identifier: MIT
#include "benchmark/training/supervised/looks.h"

#include <map>
#include <string>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

TEST(Looks, AreAFunctionOfSeedAndScene) {
  const LooksSpec spec{.share = 1.0};
  const sim::Finish finish = DrawLook(spec, 3, "house_007.glb");
  EXPECT_EQ(finish, DrawLook(spec, 3, "house_007.glb"));
  EXPECT_FALSE(finish == DrawLook(spec, 3, "house_008.glb"));
  EXPECT_FALSE(finish == DrawLook(spec, 4, "house_007.glb"));
}

TEST(Looks, HaveTheSharesThatWereAskedFor) {
  const LooksSpec spec;
  constexpr int kScenes = 4000;
  int original = 0;
  int open = 0;
  int flat = 0;
  for (int i = 0; i < kScenes; ++i) {
    const sim::Finish finish = DrawLook(spec, 1, fmt::format("{}.glb", i));
    finish.Validate();
    original += finish == sim::Finish{} ? 1 : 0;
    open += finish.ceiling ? 0 : 1;
    flat += finish.surfaces == sim::Surfaces::kFlat ? 1 : 0;
    EXPECT_TRUE(finish.baked_light || finish.surfaces != sim::Surfaces::kVertexColors);
  }
  EXPECT_NEAR(original, (1.0 - spec.share) * kScenes, 0.03 * kScenes);
  EXPECT_NEAR(open, spec.share * spec.no_ceiling * kScenes, 0.03 * kScenes);
  EXPECT_NEAR(flat, spec.share * spec.flat * kScenes, 0.03 * kScenes);
}

LooksSpec WithDamage(double share) {
  LooksSpec spec;
  spec.black_overhead = spec.blank_walls = spec.low_poly = spec.color_spacing = spec.clutter =
      share;
  spec.bumps = spec.doubled = spec.holes = spec.smears = spec.mirrored = share;
  spec.recolored = spec.exchanged = share;
  return spec;
}

TEST(Looks, EachKindOfDamageIsDrawnAsOftenAsAskedAndWithinItsRange) {
  LooksSpec spec = WithDamage(0.3);
  spec.share = 1.0;
  constexpr int kScenes = 4000;
  std::map<std::string, int> counts;
  const auto count = [&](const char* name, double share, double value, double low, double high) {
    if (share == 0.0) return;
    ++counts[name];
    EXPECT_GE(value, low) << name;
    EXPECT_LE(value, high) << name;
  };
  for (int i = 0; i < kScenes; ++i) {
    const sim::Finish finish = DrawLook(spec, 1, fmt::format("{}.glb", i));
    finish.Validate();
    const sim::Damage& damage = finish.damage;
    count("low_poly", damage.low_poly, damage.low_poly, 0.06, 0.25);
    count("color_spacing", damage.color_spacing, damage.color_spacing, 0.06, 0.2);
    count("clutter", damage.clutter, damage.clutter, 1.0, 8.0);
    count("bumps", damage.bumps.height, damage.bumps.height, 0.004, 0.05);
    count("doubled", damage.doubled.share, damage.doubled.offset, 0.02, 0.08);
    count("holes", damage.holes.share, damage.holes.share, 0.01, 0.15);
    count("smears", damage.smears.share, damage.smears.share, 0.1, 0.6);
    count("mirrored", damage.mirrored, damage.mirrored, 0.05, 0.5);
    const sim::Repaint& repaint = finish.repaint;
    count("recolored", repaint.recolored, repaint.recolored, 0.3, 1.0);
    count("exchanged", repaint.exchanged, repaint.exchanged, 0.2, 0.8);
    count("none", damage == sim::Damage{} ? 1.0 : 0.0, 1.0, 1.0, 1.0);
    if (finish.black_overhead) {
      ++counts["black_overhead"];
      EXPECT_TRUE(finish.ceiling);
    }
  }
  for (const char* name : {"low_poly", "color_spacing", "clutter", "bumps", "doubled", "holes",
                           "smears", "mirrored", "recolored", "exchanged"}) {
    EXPECT_NEAR(counts[name], 0.3 * kScenes, 0.03 * kScenes) << name;
  }
  EXPECT_NEAR(counts["black_overhead"], 0.3 * (1.0 - spec.no_ceiling) * kScenes, 0.03 * kScenes);
  EXPECT_GT(counts["none"], 0);
}

/// A training's looks stay what they were when damage is added to them.
TEST(Looks, AreTheSameBesideTheDamage) {
  const LooksSpec without;
  for (int i = 0; i < 100; ++i) {
    const std::string scene = fmt::format("{}.glb", i);
    sim::Finish finish = DrawLook(WithDamage(0.5), 1, scene);
    EXPECT_EQ(DrawLook(without, 1, scene).damage, sim::Damage{});
    finish.damage = {};
    finish.repaint = {};
    finish.black_overhead = false;
    finish.blank_walls = false;
    EXPECT_EQ(finish, DrawLook(without, 1, scene));
  }
}

TEST(Looks, WhiteScenesAreLitOrHaveAGreyFloor) {
  int unlit = 0;
  for (int i = 0; i < 400; ++i) {
    const sim::Finish finish =
        DrawLook({.share = 1.0, .flat = 0.0, .vertex_colors = 0.0, .white = 1.0}, 1,
                 fmt::format("{}.glb", i));
    EXPECT_EQ(finish.surfaces, sim::Surfaces::kAllWhite);
    EXPECT_TRUE(finish.baked_light || finish.blank_floor);
    unlit += finish.baked_light ? 0 : 1;
  }
  EXPECT_NEAR(unlit, 100, 30);
}

TEST(Looks, ShareNoneLeavesAll) {
  EXPECT_EQ(DrawLook({.share = 0.0}, 1, "a.glb"), sim::Finish{});
}

TEST(Looks, RefuseWhatIsNoShare) {
  EXPECT_THROW(LooksSpec{.share = 1.5}.Validate(), sim::Error);
  EXPECT_THROW(LooksSpec{.holes = -0.1}.Validate(), sim::Error);
  EXPECT_THROW((LooksSpec{.flat = 0.6, .white = 0.6}.Validate()), sim::Error);
  EXPECT_THROW((LooksSpec{.flat = 0.6, .vertex_colors = 0.6}.Validate()), sim::Error);
}

}  // namespace
}  // namespace bulletnav::bench
