// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "sim/simulated_body.h"
#include "tests/support/scene_checks.h"
#include "tests/support/scenes.h"

namespace bulletnav::sim {
namespace {

TEST(RealHouse, IsWalkedThrough) {
  const auto file = tests::SharedScene("aws_small_house");
  if (!file) GTEST_SKIP() << "no shared scene aws_small_house";
  const auto world = World::Load(*file, {});
  tests::CheckWalk(world, {});
  tests::CheckWalk(world, BodySpec::Locobot());
}

TEST(RealHouse, LooksTheSameFromBothBackends) {
  const auto file = tests::SharedScene("aws_small_house");
  if (!file) GTEST_SKIP() << "no shared scene aws_small_house";
  const ImportedScene scene = ImportScene(*file);
  const World world("aws_small_house", scene, {});
  tests::CheckDepthAgainstPhysics(world, 6);
  tests::CheckBackendsAgree(scene.mesh, world, 6);
}

}  // namespace
}  // namespace bulletnav::sim
