// SPDX-License-Identifier: MIT
#include "benchmark/training/supervised/samples_file.h"

#include <gmock/gmock.h>

#include "sim/base/error.h"
#include "sim/base/files.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::bench {
namespace {

using testing::HasSubstr;

SceneSamples MadeUp() {
  SceneSamples samples;
  for (int i = 0; i < 3; ++i) {
    samples.poses.push_back({Eigen::Vector3d(i, 0.25, -i), 0.1 * i});
    samples.explorable.push_back(static_cast<std::uint16_t>(0x801 + i));
    samples.reach.push_back({});
    samples.reach.back()[5] = static_cast<std::uint16_t>(100 + i);
  }
  samples.pairs.resize(9);
  samples.pairs[5] = {1, 7, 2345, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 255}};
  return samples;
}

class SamplesFileTest : public testing::Test {
 protected:
  SamplesFileTest() : file_(folder_.path() / "a.labels") { WriteSamples(file_, MadeUp(), 17); }
  std::string Complaint(std::uint64_t key = 17) const {
    try {
      ReadSamples(file_, key);
    } catch (const sim::FileError& e) {
      return e.what();
    }
    return "nothing";
  }

  tests::TemporaryFolder folder_;
  std::filesystem::path file_;
};

TEST_F(SamplesFileTest, ReadsBackWhatWasWritten) {
  const SceneSamples samples = ReadSamples(file_, 17);
  ASSERT_EQ(samples.count(), 3);
  EXPECT_EQ(samples.poses[2].position, Eigen::Vector3d(2, 0.25, -2));
  EXPECT_EQ(samples.poses[2].yaw, 0.2);
  EXPECT_EQ(samples.explorable, MadeUp().explorable);
  EXPECT_EQ(samples.reach, MadeUp().reach);
  EXPECT_EQ(samples.pairs, MadeUp().pairs);
  EXPECT_EQ(samples.pair(1, 2).distance, 2345);
  EXPECT_TRUE(samples.IsExplorable(0, 0));
  EXPECT_FALSE(samples.IsExplorable(0, 1));
  EXPECT_TRUE(samples.IsExplorable(0, 11));
}

TEST_F(SamplesFileTest, RefusesFilesOfOtherKeys) {
  EXPECT_THAT(Complaint(18), HasSubstr("was made from another scene or config"));
}

TEST_F(SamplesFileTest, RefusesAnyCutAndAnyFlippedBit) {
  const auto whole = sim::ReadFile(file_);
  for (std::size_t size = 0; size < whole.size(); size += 31) {
    sim::WriteFileAtomically(file_, std::span(whole).first(size));
    EXPECT_NE(Complaint(), "nothing") << size;
  }
  for (std::size_t i = 0; i < whole.size(); i += 5) {
    auto damaged = whole;
    damaged[i] ^= 4;
    sim::WriteFileAtomically(file_, damaged);
    EXPECT_NE(Complaint(), "nothing") << i;
  }
  auto longer = whole;
  longer.push_back(0);
  sim::WriteFileAtomically(file_, longer);
  EXPECT_THAT(Complaint(), HasSubstr("size"));
}

}  // namespace
}  // namespace bulletnav::bench
