// SPDX-License-Identifier: MIT
#include "sim/house/unfinished_houses.h"

#include <gmock/gmock.h>

#include "sim/base/error.h"
#include "sim/base/files.h"
#include "sim/house/house_set.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::sim {
namespace {

using testing::HasSubstr;

constexpr std::uint64_t kSeed = 5;

class UnfinishedHousesTest : public testing::Test {
 protected:
  /// House `number` of a call of `made_by` is written, and the call is killed.
  void Leave(const std::string& made_by, int number, std::uint64_t seed = kSeed) {
    const std::string stem = "house_00" + std::to_string(number);
    WriteFileAtomically(folder_.path() / (stem + ".glb"), made_by);
    WriteFileAtomically(folder_.path() / (stem + ".json"), made_by);
    UnfinishedHouses houses(folder_.path(), made_by, seed);
    houses.Begin();
    houses.Add({stem + ".glb", Split::kTrain, seed + number, 7, 163.957});
  }
  int Unmade(const std::string& made_by, std::uint64_t seed = kSeed) const {
    return CountUnmade(folder_.path(), {.count = 3, .first_seed = seed, .made_by = made_by});
  }

  tests::TemporaryFolder folder_;
};

TEST_F(UnfinishedHousesTest, AreKept) {
  EXPECT_EQ(Unmade("one"), 3);
  Leave("one", 2);
  EXPECT_EQ(Unmade("one"), 2);
  Leave("one", 0);
  EXPECT_EQ(Unmade("one"), 1);
  HouseEntry house{"house_002.glb", Split::kTest, kSeed + 2, 0, 0.0};
  EXPECT_TRUE(UnfinishedHouses(folder_.path(), "one", kSeed).Find(&house));
  EXPECT_EQ(house.rooms, 7);
  EXPECT_EQ(house.split, Split::kTest) << "the set's length decides, which may be another now";
}

TEST_F(UnfinishedHousesTest, OfAnotherProgramOrSeedAreMadeAnew) {
  Leave("one", 0);
  EXPECT_EQ(Unmade("two"), 3);
  EXPECT_EQ(Unmade(""), 3);
  EXPECT_EQ(Unmade("one", kSeed + 1), 3);
}

TEST_F(UnfinishedHousesTest, DoNotCountOnceAnotherBegan) {
  Leave("one", 0);
  UnfinishedHouses(folder_.path(), "two", kSeed).Begin();
  EXPECT_EQ(Unmade("one"), 3) << "its first house may be overwritten";
  Leave("one", 0);
  Leave("two", 1);
  EXPECT_EQ(Unmade("one"), 3);
  EXPECT_EQ(Unmade("two"), 2);
}

TEST_F(UnfinishedHousesTest, WithoutTheirFilesAreMadeAnew) {
  Leave("one", 0);
  Leave("one", 1);
  std::filesystem::remove(folder_.path() / "house_000.json");
  std::filesystem::remove(folder_.path() / "house_001.glb");
  EXPECT_EQ(Unmade("one"), 3);
}

TEST_F(UnfinishedHousesTest, NobodyKnowsWhoMadeAreNotNoted) {
  Leave("", 0);
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "unfinished.json"));
}

TEST_F(UnfinishedHousesTest, OnceAllAreThereTheIndexIsWrittenAndTheListGoes) {
  for (int i = 0; i < 3; ++i) Leave("one", i);
  int made = 0;
  const HouseSetSpec spec{.count = 3, .first_seed = kSeed, .made_by = "one"};
  WriteHouseSet(folder_.path(), spec, [&] {
    ++made;
  });
  EXPECT_EQ(made, 0);
  EXPECT_EQ(ReadTextFile(folder_.path() / "house_001.glb"), "one");
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "unfinished.json"));
  EXPECT_TRUE(HasHouseSet(folder_.path(), spec));
  EXPECT_EQ(Unmade("one"), 3) << "to make a finished set once more is to make all of it";
}

TEST_F(UnfinishedHousesTest, AreasAreOfTwoDigitsHoweverOftenTheyAreRead) {
  for (int i = 0; i < 3; ++i) Leave("one", i);
  WriteHouseSet(folder_.path(), {.count = 3, .first_seed = kSeed, .made_by = "one"}, [] {});
  EXPECT_THAT(ReadTextFile(folder_.path() / "index.json"), HasSubstr("\"area_m2\": 163.96\n"));
}

TEST_F(UnfinishedHousesTest, ListThatCannotBeReadIsNamedWithItsRemedy) {
  WriteFileAtomically(folder_.path() / "unfinished.json", R"({"made_by": "on)");
  try {
    Unmade("one");
    FAIL();
  } catch (const FileError& e) {
    EXPECT_THAT(e.what(), HasSubstr("unfinished.json"));
    EXPECT_THAT(e.what(), HasSubstr("remove it"));
  }
}

}  // namespace
}  // namespace bulletnav::sim
