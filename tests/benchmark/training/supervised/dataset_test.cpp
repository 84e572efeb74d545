// SPDX-License-Identifier: MIT
#include "benchmark/training/supervised/dataset.h"

#include <atomic>

#include <gmock/gmock.h>

#include "benchmark/training/supervised/label_picture.h"
#include "sim/base/error.h"
#include "sim/base/files.h"
#include "sim/image/image.h"
#include "sim/scene/glb_writer.h"
#include "tests/support/scenes.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/training_scenes.h"

namespace bulletnav::bench {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

class DatasetTest : public testing::Test {
 protected:
  DatasetTest() {
    config_.points = 5;
    config_.cache = (folder_.path() / "labels").string();
    Add("rooms.glb", tests::TwoRooms());
    Add("corridor.glb", tests::LCorridor(8, 8, 1.2f, 2.5f));
    Add("box.glb", tests::BoxRoom(6, 2.5f, 5));
  }
  void Add(const char* name, const sim::SceneMesh& mesh) {
    const auto file = folder_.path() / name;
    sim::WriteFileAtomically(file, sim::EncodeGlb(mesh));
    config_.scenes.push_back(file.string());
  }

  tests::TemporaryFolder folder_;
  DataConfig config_;
};

TEST_F(DatasetTest, IsTheSameForAnyNumberOfWorkersAndFromTheDisk) {
  DataConfig other = config_;
  other.cache = (folder_.path() / "other").string();
  std::atomic<int> done = 0;
  const auto alone = LabelScenes(config_, 1, [&](const LabelledScene&) {
    ++done;
  });
  const auto together = LabelScenes(other, 3, {});
  const auto again = LabelScenes(config_, 2, {});
  EXPECT_EQ(done, 3);
  for (std::size_t s = 0; s < 3; ++s) {
    EXPECT_FALSE(alone[s].was_cached);
    EXPECT_TRUE(again[s].was_cached);
    EXPECT_EQ(alone[s].file, config_.scenes[s]);
    EXPECT_EQ(alone[s].samples.pairs, again[s].samples.pairs);
    EXPECT_EQ(sim::ReadFile(SamplesFile(config_.scenes[s], config_)),
              sim::ReadFile(SamplesFile(config_.scenes[s], other)));
  }
}

TEST_F(DatasetTest, OtherConfigsAndChangedScenesHaveTheirOwnFiles) {
  const std::filesystem::path scene = config_.scenes[2];
  LabelScene(scene, config_);
  DataConfig other = config_;
  other.seed = 9;
  EXPECT_FALSE(LabelScene(scene, other).was_cached);
  EXPECT_TRUE(LabelScene(scene, config_).was_cached);
  sim::WriteFileAtomically(scene, sim::EncodeGlb(tests::BoxRoom(6.1f, 2.5f, 5)));
  EXPECT_FALSE(LabelScene(scene, config_).was_cached);
}

TEST_F(DatasetTest, DamagedFilesAreMadeAnewWithANote) {
  const std::filesystem::path scene = config_.scenes[2];
  const auto first = LabelScene(scene, config_);
  EXPECT_THAT(first.note, IsEmpty());
  const auto file = SamplesFile(scene, config_);
  auto bytes = sim::ReadFile(file);
  bytes[100] ^= 1;
  sim::WriteFileAtomically(file, bytes);
  const auto second = LabelScene(scene, config_);
  EXPECT_FALSE(second.was_cached);
  EXPECT_THAT(second.note, HasSubstr("checksum"));
  EXPECT_EQ(second.samples.pairs, first.samples.pairs);
  EXPECT_TRUE(LabelScene(scene, config_).was_cached);
}

TEST_F(DatasetTest, ScenesThatCannotBeReadAreErrorsWithTheirName) {
  config_.scenes = {"nowhere.glb"};
  try {
    LabelScenes(config_, 1, {});
    FAIL();
  } catch (const sim::FileError& e) {
    EXPECT_THAT(e.what(), HasSubstr("nowhere.glb"));
  }
}

TEST_F(DatasetTest, DrawsAPictureAPoint) {
  const auto scene = LabelScene(config_.scenes[0], config_);
  const auto files = DrawLabels(scene, config_, 2, folder_.path() / "pictures");
  ASSERT_EQ(files.size(), 2u);
  // With the folder's name, since files in several folders may be called alike.
  EXPECT_EQ(files[1].filename().string(), folder_.path().filename().string() + "-rooms-001.png");
  EXPECT_GT(sim::DecodeImage(sim::ReadFile(files[1])).width, 1000);
}

}  // namespace
}  // namespace bulletnav::bench
