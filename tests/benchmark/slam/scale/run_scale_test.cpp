// SPDX-License-Identifier: MIT
#include "benchmark/slam/scale/run_scale.h"

#include <filesystem>

#include <gmock/gmock.h>

#include "benchmark/slam/plots/scale_chart.h"
#include "sim/base/error.h"
#include "tests/support/houses.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

class RunScale : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new tests::TemporaryFolder();
    tests::WriteShellHouses(folder_->path() / "houses", 3, 1);
  }
  static void TearDownTestSuite() {
    delete folder_;
    folder_ = nullptr;
  }
  static ScaleConfig Config(const std::string& more) {
    const auto house = [](int number) {
      return (folder_->path() / "houses/house_00").string() + std::to_string(number) + ".glb";
    };
    return LoadScaleConfig(folder_->Write(
        "small.yaml", "query_scenes: [" + house(0) + "]\nother_scenes: [" + house(1) + ", " +
                          house(2) +
                          "]\ncamera: {rows: 96, cols: 128}\napart_m: 2\nactions: 60\n"
                          "other_actions: 60\ndescriptors: " +
                          BULLETNAV_WEIGHTS + "/place_rgb.safetensors\n" + more));
  }
  static tests::TemporaryFolder* folder_;
};

tests::TemporaryFolder* RunScale::folder_ = nullptr;

TEST_F(RunScale, MoreFramesMakeNothingEasierAndThreadsChangeNothing) {
  const ScaleConfig config = Config("sizes: [61, 120]\nquery_every: 1\n");
  EXPECT_EQ(config.name, "small");
  const PlayedScale played = PlayScale(config, 1, {});
  EXPECT_GT(played.result.queries, 5);
  ASSERT_EQ(played.result.figures.size(), 2u);
  const ScaleFigures& few = played.result.figures[0];
  const ScaleFigures& many = played.result.figures[1];
  EXPECT_EQ(few.frames, 61);
  EXPECT_LE(few.recall_1, few.recall_5);
  EXPECT_LE(few.recall_5, few.recall_10);
  EXPECT_GT(few.recall_10, 0.0);
  EXPECT_LE(many.recall_1, few.recall_1);
  EXPECT_LE(many.recall_10, few.recall_10);
  EXPECT_NEAR(few.index_mb, 61.0 * 256.0 * 2.0 / (1 << 20), 1e-9);
  EXPECT_GT(played.times.describing.median_ms, 0.0);
  EXPECT_THAT(ScaleTable(played), HasSubstr("| 120 |"));
  const fs::path stem = folder_->path() / "recall";
  WriteFigure(ScaleFigure(played.result), stem);
  EXPECT_TRUE(fs::exists(stem.string() + ".svg"));
  const PlayedScale again = PlayScale(config, 3, {});
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(again.result.figures[i].recall_1, played.result.figures[i].recall_1);
    EXPECT_EQ(again.result.figures[i].recall_10, played.result.figures[i].recall_10);
  }
}

TEST_F(RunScale, BadConfigsAreTold) {
  const auto load = [](const std::string& more) {
    return [more] {
      PlayScale(Config(more), 1, {});
    };
  };
  EXPECT_THAT(load("sizes: [60]\n"), ThrowsMessage<sim::Error>(HasSubstr("above 'actions'")));
  EXPECT_THAT(load("sizes: [200, 100]\n"), ThrowsMessage<sim::Error>(HasSubstr("must rise")));
  EXPECT_THAT(load("sizes: [100000]\n"), ThrowsMessage<sim::Error>(HasSubstr("100000 frames")));
  EXPECT_THAT(load("others: test\nsizes: [61]\n"),
              ThrowsMessage<sim::Error>(HasSubstr("another split")));
  ScaleConfig config = Config("sizes: [61]\n");
  config.other_scenes.push_back(
      (folder_->path() / "houses/../houses" / fs::path(config.query_scenes[0]).filename())
          .string());
  const auto play = [&config] {
    PlayScale(config, 1, {});
  };
  EXPECT_THAT(play, ThrowsMessage<sim::FileError>(HasSubstr("is there twice")));
  config.query_scenes.clear();
  EXPECT_THAT(play, ThrowsMessage<sim::Error>(HasSubstr("name 'query_scenes'")));
}

TEST(ScaleConfig, TheShippedOneLoads) {
  EXPECT_EQ(LoadScaleConfig(fs::path(BULLETNAV_CONFIGS) / "slam/scale.yaml").sizes.back(), 100000);
}

}  // namespace
}  // namespace bulletnav::bench
