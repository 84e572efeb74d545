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

}  // namespace
}  // namespace bulletnav::bench
