// SPDX-License-Identifier: MIT
#include "benchmark/episodes/made_houses.h"

#include <chrono>
#include <optional>
#include <thread>

#include <gmock/gmock.h>

#include "sim/base/error.h"
#include "sim/base/folder_lock.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::bench {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(MakeHouses, WaitsForAnotherProcessAndThenMakesWhatIsMissing) {
  const tests::TemporaryFolder folder;
  std::optional<sim::FolderLock> other(folder.path());
  std::thread release;
  std::vector<std::string> told;
  const StartProgress start = [&](const std::string& what, int /*total*/) {
    told.push_back(what);
    if (what.starts_with("waiting") && !release.joinable()) {
      release = std::thread([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        other.reset();
      });
    }
    return [] {};
  };
  const HousesSpec houses = {.folder = folder.path().string(), .count = 1, .first_seed = 7};
  EXPECT_THROW(FilesOf(houses), sim::FileError);
  MakeHouses(houses, "", 2, start);
  release.join();
  EXPECT_THAT(told, ElementsAre("generating houses", HasSubstr("waiting for a process"),
                                "generating houses"));
  EXPECT_EQ(FilesOf(houses).size(), 1u);
  MakeHouses(houses, "", 2, start);
  EXPECT_EQ(told.size(), 3u);
}

TEST(MakeHouses, AFileOfASetStandsForItsSeedAndParts) {
  const tests::TemporaryFolder folder;
  const std::string file =
      folder.Write("set.yaml", "first_seed: 9\nparts:\n  - {kind: home, count: 1}\n").string();
  const std::string made = (folder.path() / "made").string();
  const HousesSpec named = {.folder = made, .set = file};
  const StartProgress start = [](const std::string&, int) {
    return [] {};
  };
  MakeHouses(named, "", 1, start);
  EXPECT_EQ(FilesOf(named).size(), 1u);
  const HousesSpec spelled = {
      .folder = made, .first_seed = 9, .parts = {{{.kind = "home", .count = 1}}}};
  EXPECT_EQ(FilesOf(spelled), FilesOf(named));
  folder.Write("set.yaml", "first_seed: 9\nparts:\n  - {kind: home, count: 2}\n");
  EXPECT_THROW(FilesOf(named), sim::FileError) << "the folder holds those of before";
}

TEST(MakeHouses, ComplaintsAboutAFileOfASetNameIt) {
  const tests::TemporaryFolder folder;
  HousesSpec houses = {.folder = folder.path().string()};
  const auto complaint = [&](const std::string& text) {
    houses.set = folder.Write("set.yaml", text).string();
    try {
      FilesOf(houses);
    } catch (const sim::FileError& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  EXPECT_THAT(complaint("parts: []\n"), HasSubstr("set.yaml:1:8: 'parts' has no entry"));
  EXPECT_THAT(complaint("parts:\n  - {kind: hom}\n"), HasSubstr("set.yaml:2"));
  EXPECT_THAT(complaint("folder: a\n"), HasSubstr("unknown key 'folder'"));
  houses.set = "nowhere.yaml";
  EXPECT_THROW(FilesOf(houses), sim::FileError);
  houses.first_seed = 4;
  EXPECT_THROW(houses.Validate(), sim::KeyError) << "the file gives it";
}

}  // namespace
}  // namespace bulletnav::bench
