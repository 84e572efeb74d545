// SPDX-License-Identifier: MIT
#include "benchmark/training/supervised/scene_batches.h"

#include <gmock/gmock.h>

#include "sim/base/error.h"
#include "sim/base/files.h"
#include "sim/scene/glb_writer.h"
#include "tests/support/scenes.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/training_scenes.h"

namespace bulletnav::bench {
namespace {

class SceneBatchesTest : public testing::Test {
 protected:
  SceneBatchesTest() {
    config_.points = 6;
    config_.cache = (folder_.path() / "labels").string();
    Add("rooms.glb", tests::TwoRooms());
    Add("box.glb", tests::BoxRoom(6, 2.5f, 5));
  }
  void Add(const char* name, const sim::SceneMesh& mesh) {
    const auto file = folder_.path() / name;
    sim::WriteFileAtomically(file, sim::EncodeGlb(mesh));
    config_.scenes.push_back(file.string());
  }
  SceneBatches Make(int panoramas, std::uint64_t seed = 1, double near_batches = 0.0) const {
    return {config_, {panoramas, true, near_batches, seed}, {}};
  }

  tests::TemporaryFolder folder_;
  DataConfig config_;
};

TEST_F(SceneBatchesTest, ABatchDependsOnItsNumberAlone) {
  SceneBatches one = Make(4);
  SceneBatches other = Make(4);
  const PairBatch first = one.Batch(7);
  one.Batch(8);
  other.Batch(3);
  const PairBatch second = other.Batch(7);
  EXPECT_EQ(first.color, second.color);
  EXPECT_EQ(first.depth, second.depth);
  EXPECT_EQ(first.scores, second.scores);
  EXPECT_EQ(first.same_node, second.same_node);
  EXPECT_NE(first.depth, other.Batch(9).depth);
  EXPECT_NE(first.depth, Make(4, 2).Batch(7).depth);
}

TEST_F(SceneBatchesTest, LabelsStandWhereTheyBelong) {
  SceneBatches batches = Make(5);
  int near = 0;
  for (std::uint64_t number = 0; number < 6; ++number) {
    const PairBatch batch = batches.Batch(number);
    for (int pair = 0; pair < 25; ++pair) {
      const auto i = static_cast<std::size_t>(pair);
      const bool is_pair = pair / 5 != pair % 5;
      const bool is_near = batch.same_node[i] != 0;
      EXPECT_EQ(batch.direction[i] >= 0, is_pair && is_near);
      EXPECT_EQ(batch.scores[12 * i] >= 0.0f, is_pair && !is_near);
      near += is_pair && is_near ? 1 : 0;
    }
  }
  EXPECT_GT(near, 0);
}

TEST_F(SceneBatchesTest, NearBatchesHoldMorePairsOfOneNode) {
  config_.points = 40;
  config_.scenes.resize(1);
  const auto near_pairs = [](const SceneBatches& batches) {
    int near = 0;
    for (std::uint64_t number = 0; number < 8; ++number) {
      const PairBatch batch = batches.Batch(number);
      for (const std::uint8_t same_node : batch.same_node) near += same_node;
    }
    return near;
  };
  EXPECT_GT(near_pairs(Make(5, 1, 1.0)), 1.3 * near_pairs(Make(5)));
}

TEST_F(SceneBatchesTest, RefusesMorePanoramasThanThereArePoints) {
  EXPECT_THROW(Make(7), sim::Error);
}

}  // namespace
}  // namespace bulletnav::bench
