// SPDX-License-Identifier: MIT
#include "benchmark/evaluate_perception/perception_cases.h"

#include <atomic>

#include <gmock/gmock.h>

#include "benchmark/evaluate_perception/perception_figures.h"
#include "benchmark/evaluate_perception/perception_report.h"
#include "sim/base/error.h"
#include "sim/base/files.h"
#include "sim/scene/glb_writer.h"
#include "tests/support/scenes.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/training_scenes.h"

namespace bulletnav::bench {
namespace {

/// Knows a panorama by its middle depth and its first colour.
class DepthModel final : public agent::SemanticModel {
 public:
  std::vector<agent::PanoramaCode> Encode(std::span<const agent::Panorama> panoramas) override {
    std::vector<agent::PanoramaCode> codes;
    for (const agent::Panorama& panorama : panoramas) {
      codes.push_back(
          {panorama.depth[panorama.depth.size() / 2], static_cast<float>(panorama.color.front())});
    }
    return codes;
  }
  PerDirection Explorable(const agent::PanoramaCode& source) override {
    PerDirection all;
    all.fill(0.1f * source[0]);
    return all;
  }
  std::vector<agent::PairPrediction> Compare(std::span<const agent::PanoramaCode* const> sources,
                                             const agent::PanoramaCode& goal) override {
    std::vector<agent::PairPrediction> predictions;
    for (const agent::PanoramaCode* source : sources) {
      agent::PairPrediction& said = predictions.emplace_back();
      said.same_node = 0.1f * (*source)[0];
      said.distance = goal[0];
      said.direction[3] = 1.0f;
      said.score.fill(0.01f * goal[0]);
    }
    return predictions;
  }
};

class PerceptionCasesTest : public testing::Test {
 protected:
  PerceptionCasesTest() {
    config_.data.points = 6;
    config_.data.panorama.rows = 64;
    config_.data.panorama.cols = 256;
    config_.data.cache = (folder_.path() / "labels").string();
    Add("rooms.glb", tests::TwoRooms());
    Add("corridor.glb", tests::LCorridor(8, 8, 1.2f, 2.5f));
    Add("box.glb", tests::BoxRoom(6, 2.5f, 5));
  }
  void Add(const char* name, const sim::SceneMesh& mesh) {
    const auto file = folder_.path() / name;
    sim::WriteFileAtomically(file, sim::EncodeGlb(mesh));
    config_.data.scenes.push_back(file.string());
  }
  std::vector<SceneCases> Make(int workers, const CasesProgress& progress = {}) {
    return MakeCases(config_.data, std::make_shared<DepthModel>, workers, progress);
  }

  tests::TemporaryFolder folder_;
  PerceptionConfig config_;
};

TEST_F(PerceptionCasesTest, AreTheSameForAnyNumberOfWorkers) {
  std::atomic<int> places = 0;
  CasesProgress progress;
  progress.on_place = [&] {
    ++places;
  };
  const auto alone = Make(1, progress);
  EXPECT_EQ(places, 18);
  const auto together = Make(3);
  EXPECT_EQ(ToJson(MeasurePerception(alone, config_), config_, {}),
            ToJson(MeasurePerception(together, config_), config_, {}));
}

TEST_F(PerceptionCasesTest, PutEachAnswerWhereItsQuestionIs) {
  const SceneCases rooms = Make(1).front();
  ASSERT_EQ(rooms.count(), 6);
  int walls = 0;
  ForEachPair(rooms, [&](int source, int goal) {
    EXPECT_EQ(rooms.prediction(source, goal).same_node,
              rooms.explorable[static_cast<std::size_t>(source)][0]);
    EXPECT_EQ(rooms.prediction(source, goal).score[0],
              0.01f * rooms.prediction(source, goal).distance);
    EXPECT_EQ(rooms.walls_between(source, goal), rooms.walls_between(goal, source));
    EXPECT_LE(rooms.walls_between(source, goal), 1);
    walls += rooms.walls_between(source, goal);
  });
  EXPECT_GT(walls, 0);
}

TEST_F(PerceptionCasesTest, MissingScenesAreAnError) {
  config_.data.scenes.emplace_back("nowhere.glb");
  EXPECT_THROW(Make(2), sim::Error);
}

}  // namespace
}  // namespace bulletnav::bench
