// SPDX-License-Identifier: MIT
#include "benchmark/evaluate_perception/perception_pictures.h"

#include <gmock/gmock.h>

#include "benchmark/evaluate_perception/direction_strip.h"
#include "benchmark/evaluate_perception/example_figures.h"
#include "benchmark/evaluate_perception/perception_charts.h"
#include "sim/base/files.h"
#include "sim/scene/glb_writer.h"
#include "tests/benchmark/evaluate_perception/fake_cases.h"
#include "tests/support/svg.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/training_scenes.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::IsEmpty;

std::vector<std::string> NamesIn(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    names.push_back(entry.path().filename().string());
  }
  return names;
}

class PerceptionPicturesTest : public testing::Test {
 protected:
  PerceptionPicturesTest() {
    const fs::path scene = folder_.path() / "rooms.glb";
    sim::WriteFileAtomically(scene, sim::EncodeGlb(tests::TwoRooms()));
    cases_ = tests::RandomCases(3, 12);
    cases_.scene = scene;
    for (sim::BodyPose& pose : cases_.samples.poses) {  // from a square of 12 m into the rooms
      pose.position.x() *= 0.6;
      pose.position.z() = -0.3 * pose.position.z() - 0.2;
    }
    tests::PredictTruth(&cases_);
    config_.pictures = 1;
  }

  tests::TemporaryFolder folder_;
  SceneCases cases_;
  PerceptionConfig config_;
};

TEST_F(PerceptionPicturesTest, AreOfEveryKindSoundAndTheSameForOneSeed) {
  const fs::path first = folder_.path() / "first";
  const fs::path second = folder_.path() / "second";
  int done = 0;
  DrawExamples({&cases_, 1}, config_, first, [&] {
    ++done;
  });
  EXPECT_EQ(done, 1);
  DrawExamples({&cases_, 1}, config_, second, {});
  for (const char* kind : {"explorable-1", "relative_pose-1", "scores-1", "choices-1"}) {
    const std::string name = kind;
    ASSERT_THAT(NamesIn(first), Contains(name + ".png"));
    const std::string svg = sim::ReadTextFile(first / (name + ".svg"));
    EXPECT_THAT(tests::SvgProblem(svg), IsEmpty()) << name;
    EXPECT_EQ(svg, sim::ReadTextFile(second / (name + ".svg"))) << name;
  }
}

TEST_F(PerceptionPicturesTest, LeaveOutWhatThereIsNoExampleOf) {
  cases_.samples.explorable.assign(12, 0);
  for (PairLabel& pair : cases_.samples.pairs) pair.same_node = 0;
  DrawExamples({&cases_, 1}, config_, folder_.path() / "few", {});
  EXPECT_THAT(NamesIn(folder_.path() / "few"),
              testing::UnorderedElementsAre("explorable-1.png", "explorable-1.svg"));
}

TEST_F(PerceptionPicturesTest, ChoicesOfAPerfectModelAreTheBest) {
  cases_.samples.explorable[0] = 0b101;
  const Choice choice = ChoiceOf(cases_, 0, 1);
  EXPECT_EQ(choice.said, choice.best);
  cases_.samples.explorable[0] = 0;
  EXPECT_EQ(ChoiceOf(cases_, 0, 1).said, -1);
}

TEST(DirectionStrip, HasBehindFirstAndGoesClockwise) {
  Canvas canvas(120, 40, kWhite);
  const DirectionStrip strip(0.0, 120.0, &canvas);
  EXPECT_DOUBLE_EQ(strip.At(6), 5.0);
  EXPECT_DOUBLE_EQ(strip.At(3), 35.0);  // left
  EXPECT_DOUBLE_EQ(strip.At(0), 65.0);
  EXPECT_DOUBLE_EQ(strip.At(9), 95.0);
  EXPECT_DOUBLE_EQ(strip.At(7), 115.0);
  for (int i = 0; i < agent::kDirections; ++i) {
    EXPECT_NEAR(strip.AtBearing(BearingOf(i)), strip.At(i), 1e-9);
  }
}

TEST(PerceptionCharts, AreSoundAlsoForNoPairs) {
  std::vector<SceneCases> scenes(2, tests::RandomCases(1, 10));
  for (SceneCases& cases : scenes) tests::PredictConstant(&cases);
  for (const ConnectionFigures& figures :
       {MeasureConnection(scenes, 0.5, 0), MeasureConnection({}, 0.5, 0)}) {
    EXPECT_THAT(tests::SvgProblem(ToSvg(PrecisionRecallFigure(figures))), IsEmpty());
    EXPECT_THAT(tests::SvgProblem(ToSvg(ConnectionBinsFigure(figures))), IsEmpty());
  }
}

}  // namespace
}  // namespace bulletnav::bench
