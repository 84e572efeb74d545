// SPDX-License-Identifier: MIT
#include "benchmark/training/supervised/looks.h"

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

TEST(Looks, ShareNoneLeavesAll) {
  EXPECT_EQ(DrawLook({.share = 0.0}, 1, "a.glb"), sim::Finish{});
}

TEST(Looks, RefuseWhatIsNoShare) {
  EXPECT_THROW(LooksSpec{.share = 1.5}.Validate(), sim::Error);
  EXPECT_THROW((LooksSpec{.flat = 0.6, .vertex_colors = 0.6}.Validate()), sim::Error);
}

}  // namespace
}  // namespace bulletnav::bench
