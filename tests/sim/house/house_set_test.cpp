// SPDX-License-Identifier: MIT
#include "sim/house/house_set.h"

#include <gmock/gmock.h>

#include "sim/base/error.h"
#include "sim/base/files.h"
#include "sim/base/folder_lock.h"
#include "sim/house/house_json.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::sim {
namespace {

using testing::HasSubstr;

class HouseSetTest : public testing::Test {
 protected:
  /// `more`: keys before the houses.
  void WriteIndex(const std::string& more = "") {
    WriteFileAtomically(folder_.path() / "index.json",
                        R"({"first_seed": 5, )" + more + R"("houses": [
             {"file": "house_000.glb", "split": "train", "seed": 5, "rooms": 7, "area_m2": 90.5},
             {"file": "house_001.glb", "split": "test", "seed": 6, "rooms": 4, "area_m2": 50}]})");
  }
  std::string Complaint(const HouseSetSpec& spec) const {
    try {
      HasHouseSet(folder_.path(), spec);
    } catch (const Error& e) {
      return e.what();
    }
    return "none";
  }

  tests::TemporaryFolder folder_;
};

TEST_F(HouseSetTest, IsThereOnceItsIndexIs) {
  EXPECT_FALSE(HasHouseSet(folder_.path(), {.count = 2, .first_seed = 5}));
  WriteIndex();
  EXPECT_TRUE(HasHouseSet(folder_.path(), {.count = 2, .first_seed = 5}));
}

TEST_F(HouseSetTest, OtherHousesAreRefused) {
  WriteIndex();
  for (const HouseSetSpec& spec :
       {HouseSetSpec{.count = 2, .first_seed = 6}, HouseSetSpec{.count = 1, .first_seed = 5},
        HouseSetSpec{.count = 3, .first_seed = 5}}) {
    EXPECT_THAT(Complaint(spec),
                HasSubstr("index.json: lists 2 houses of seeds 5 to 6; asked for: "));
    EXPECT_THROW(WriteHouseSet(folder_.path(), spec, [] {}), FileError);
  }
}

TEST_F(HouseSetTest, RefurnishedHousesAreOthers) {
  WriteIndex();
  const HouseSetSpec plain{.count = 2, .first_seed = 5};
  HouseSetSpec refurnished = plain;
  refurnished.refurnished.share = 0.3;
  EXPECT_THAT(Complaint(refurnished),
              HasSubstr("2 houses of seeds 5 to 6 with 30% of the rooms refurnished by seed 1"));
  WriteIndex(R"("refurnished": {"share": 0.3, "seed": 1}, )");
  EXPECT_TRUE(HasHouseSet(folder_.path(), refurnished));
  EXPECT_THAT(Complaint(plain), HasSubstr("lists 2 houses of seeds 5 to 6 with 30%"));
  refurnished.refurnished.seed = 2;
  EXPECT_THAT(Complaint(refurnished), HasSubstr("by seed 2"));
}

/// A folder of that name stands in for a full disk.
TEST_F(HouseSetTest, NoHouseIsBegunAfterOneCannotBeWritten) {
  MakeFolder(folder_.path() / "house_000.glb");
  int advanced = 0;
  const auto advance = [&] {
    ++advanced;
  };
  EXPECT_THROW(WriteHouseSet(folder_.path(), {.count = 3, .first_seed = 0, .workers = 1}, advance),
               FileError);
  EXPECT_EQ(advanced, 0);
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "house_001.glb"));
}

TEST_F(HouseSetTest, OneProcessWritesAFolder) {
  const FolderLock other(folder_.path());
  try {
    WriteHouseSet(folder_.path(), {.count = 1, .first_seed = 0}, [] {});
    ADD_FAILURE() << "wrote beside another";
  } catch (const Error& e) {
    EXPECT_THAT(e.what(), HasSubstr("is writing here"));
  }
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "house_000.glb"));
}

TEST_F(HouseSetTest, CountsOutOfRangeAreRefused) {
  EXPECT_THAT(Complaint({.count = 0}), "none") << "no index yet";
  EXPECT_THROW(WriteHouseSet(folder_.path(), {.count = 0}, [] {}), Error);
  WriteIndex();
  EXPECT_THAT(Complaint({.count = 10000}), HasSubstr("it must be in 1..9999"));
}

TEST_F(HouseSetTest, PartsAreWrittenWithTheirKindsSplitsAndFurniture) {
  const SetPart small{.kind = "warehouse",
                      .split = Split::kVal,
                      .count = 1,
                      .min_area_m2 = 120,
                      .max_area_m2 = 150};
  const SetPart home{.kind = "home", .split = Split::kTest, .count = 1};
  const HouseSetSpec spec{.first_seed = 4, .parts = {small, home}, .workers = 1};
  WriteHouseSet(folder_.path(), spec, [] {});
  EXPECT_TRUE(HasHouseSet(folder_.path(), spec));
  const auto entries = ReadHouseIndex(folder_.path() / "index.json");
  ASSERT_EQ(entries.size(), 2U);
  EXPECT_EQ(entries[0].file, "warehouse_000.glb");
  EXPECT_EQ(entries[0].kind, "warehouse");
  EXPECT_EQ(entries[0].split, Split::kVal);
  EXPECT_LE(entries[0].area_m2, 150.0);
  EXPECT_EQ(entries[1].file, "home_000.glb");
  EXPECT_EQ(entries[1].split, Split::kTest);
  EXPECT_FALSE(ReadHouseJson(folder_.path() / "warehouse_000.json").furniture.empty());

  HouseSetSpec other = spec;
  other.parts[0].split = Split::kTrain;
  EXPECT_THROW(HasHouseSet(folder_.path(), other), FileError);
}

TEST(SetPartTest, SaysWhatCannotBeMade) {
  EXPECT_THROW(SetPart{.kind = "ofice"}.Validate(), Error);
  EXPECT_THROW((SetPart{.kind = "office", .count = 0}).Validate(), Error);
  EXPECT_THROW((SetPart{.kind = "office", .min_area_m2 = 5000}).Validate(), Error);
  EXPECT_THROW((SetPart{.kind = "home", .max_area_m2 = 150}).Validate(), Error);
}

}  // namespace
}  // namespace bulletnav::sim
