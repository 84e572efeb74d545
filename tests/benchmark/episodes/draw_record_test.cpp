// SPDX-License-Identifier: MIT
#include "benchmark/episodes/draw_record.h"

#include <gmock/gmock.h>

#include "sim/base/error.h"
#include "sim/base/files.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::bench {
namespace {

using testing::HasSubstr;

class DrawRecordTest : public testing::Test {
 protected:
  DrawRecordTest() {
    const auto scene = folder_.path() / "a.glb";
    sim::WriteFileAtomically(scene, "a mesh");
    spec_.scenes = {scene.string()};
    spec_.counts.easy = 3;
    spec_.out = "episodes.json";
    set_.other = DrawRecord(spec_, spec_.scenes);
  }
  std::string Complaint() const {
    try {
      RequireDrawnFrom(set_, spec_, "episodes.json");
    } catch (const sim::FileError& e) {
      return e.what();
    }
    return "none";
  }

  tests::TemporaryFolder folder_;
  GeneratorSpec spec_;
  EpisodeSet set_;
};

TEST_F(DrawRecordTest, TheSameDrawPassesUnderAnyName) {
  EXPECT_EQ(Complaint(), "none");
  spec_.out = "elsewhere.json";
  EXPECT_EQ(Complaint(), "none");
}

TEST_F(DrawRecordTest, SurvivesItsFile) {
  Episode episode;
  episode.id = "1";
  episode.scene = spec_.scenes[0];
  episode.goals.resize(1);
  set_.episodes = {episode};
  const auto file = folder_.path() / "e.json.gz";
  WriteEpisodes(file, set_);
  set_ = ReadEpisodes(file);
  EXPECT_EQ(Complaint(), "none");
  spec_.seed = 1;
  EXPECT_THAT(Complaint(), HasSubstr("another config"));
}

TEST_F(DrawRecordTest, OtherDrawIsRefusedWithARemedy) {
  spec_.counts.easy = 4;
  EXPECT_EQ(Complaint(),
            "episodes.json: was drawn by another config; remove the file to have it drawn again, "
            "or give episodes another file");
}

TEST_F(DrawRecordTest, LooksDoNotMatterButCeilingsDo) {
  spec_.import.finish = sim::Finish();
  spec_.import.finish->surfaces = sim::Surfaces::kAllWhite;
  EXPECT_EQ(Complaint(), "none");
  spec_.import.finish->ceiling = false;
  EXPECT_THAT(Complaint(), HasSubstr("another config"));
}

TEST_F(DrawRecordTest, ChangedSceneIsRefused) {
  sim::WriteFileAtomically(spec_.scenes[0], "another mesh");
  EXPECT_THAT(Complaint(), HasSubstr("was drawn in other scenes; remove the file"));
}

TEST_F(DrawRecordTest, SetsFromElsewherePass) {
  for (const char* other : {"", "{}", "{\"split\":\"val\"}", "{\"drawn_from\":\"a hat\"}"}) {
    set_.other = other;
    EXPECT_EQ(Complaint(), "none") << other;
  }
}

}  // namespace
}  // namespace bulletnav::bench
