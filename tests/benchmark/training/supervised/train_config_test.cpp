// SPDX-License-Identifier: MIT
#include "benchmark/training/supervised/train_config.h"

#include <gmock/gmock.h>

#include "benchmark/training/supervised/nts_training.h"
#include "sim/base/error.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::bench {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

std::filesystem::path Shipped(const std::string& name) {
  return std::filesystem::path(BULLETNAV_SOURCE_DIR) / "configs/train" / (name + ".yaml");
}

TEST(TrainConfig, ShippedConfigsLoad) {
  for (const std::string name : {"nts_rgbd", "nts_rgb"}) {
    const auto config = sim::LoadYaml<TrainConfig>(Shipped(name));
    EXPECT_EQ(config.model.uses_depth(), name == "nts_rgbd");
  }
  EXPECT_TRUE(sim::LoadYaml<TrainConfig>(Shipped("own_scenes")).start);
  EXPECT_EQ(ValidationData(sim::LoadYaml<MapperTrainConfig>(Shipped("mapper_rgb"))).houses->split,
            "val");
}

/// Checkpoints hold this text: other words in it, and trainings cannot be gone on with.
TEST(TrainConfig, ItsEssenceStaysAsItIs) {
  TrainConfig config;
  config.out = "somewhere";
  const std::string essence = TrainJob::Of<NtsTraining>(config, nullptr).essence;
  EXPECT_THAT(essence, StartsWith("out: \"\"\nmodel:\n  encoder: panorama\n"));
  EXPECT_THAT(essence, HasSubstr("steps: 20000\nscenes: 4\nlanes: 2\npanoramas: 16\npairs: 64\n"
                                 "validate_every: 500\nvalidation_batches: 32\nseed: 0\n"));
}

TEST(TrainConfig, ScoreContrastIsReadAndChecked) {
  const tests::TemporaryFolder folder;
  const auto config = sim::LoadYaml<TrainConfig>(
      folder.Write("a.yaml", "out: x\nscore_contrast: {weight: 50, from_step: 7}\n"));
  ASSERT_TRUE(config.score_contrast.has_value());
  EXPECT_EQ(config.score_contrast->weight, 50.0);
  EXPECT_EQ(config.score_contrast->from_step, 7);
  for (const char* bad : {"{weight: -1}", "{weight: .nan}", "{weight: 1, from_step: -1}", "{}"}) {
    EXPECT_THROW(sim::LoadYaml<TrainConfig>(
                     folder.Write("b.yaml", std::string("out: x\nscore_contrast: ") + bad + "\n")),
                 sim::FileError)
        << bad;
  }
}

std::string ErrorOf(const std::string& text) {
  try {
    sim::LoadYamlText<TrainConfig>(text, "c.yaml");
  } catch (const sim::FileError& e) {
    return e.what();
  }
  return "none";
}

TEST(TrainConfig, ScenesThatLanesDoNotDivideAreNamed) {
  EXPECT_EQ(ErrorOf("out: x\nscenes: 3\n"),
            "c.yaml:2:9: scenes is 3; it must be a multiple of lanes, 2");
  EXPECT_EQ(ErrorOf("out: x\nscenes: 3\nlanes: 3\n"), "none");
}

TEST(TrainConfig, DataWithoutHousesNeedsABlockToValidateOn) {
  const std::string data = "out: x\ndata:\n  scenes: [a.glb]\n  cache: c\n";
  EXPECT_THAT(ErrorOf(data), HasSubstr("add a block 'validation'"));
  EXPECT_THAT(ErrorOf(data), StartsWith("c.yaml:3:3: "));
  EXPECT_EQ(ErrorOf(data + "validation: {scenes: [b.glb], cache: c}\n"), "none");
}

TEST(TrainConfig, RejectionIsReadAndChecked) {
  const tests::TemporaryFolder folder;
  const auto config = sim::LoadYaml<TrainConfig>(folder.Write("a.yaml", "out: x\nrejection: 10\n"));
  EXPECT_EQ(config.rejection, 10.0);
  for (const char* bad : {"-1", ".nan", "much"}) {
    EXPECT_THROW(sim::LoadYaml<TrainConfig>(
                     folder.Write("b.yaml", std::string("out: x\nrejection: ") + bad + "\n")),
                 sim::FileError)
        << bad;
  }
}

std::string Complaint(const std::string& text) {
  try {
    MakeTraining(sim::ParseYaml(text, "c.yaml"), "nts", {});
  } catch (const sim::FileError& e) {
    return e.what();
  }
  return "none";
}

TEST(Trainers, AreKnownByName) {
  EXPECT_THAT(TrainerNames(), ::testing::IsSupersetOf({"mapper", "nts"}));
  EXPECT_EQ(Complaint("out: x\ntask: maper\n"),
            "c.yaml:2:7: unknown task 'maper'; known are: distillation, exploration, four_rooms, "
            "imitation, "
            "mapper, memory, nts, ppo");
  EXPECT_THAT(Complaint("task: mapper\nout: x\npairs: 8\n"), StartsWith("c.yaml:3:1: "));
  EXPECT_THAT(Complaint("out: x\npairs: 8\n"), HasSubstr("no block 'data'"));
}

}  // namespace
}  // namespace bulletnav::bench
