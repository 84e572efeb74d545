// SPDX-License-Identifier: MIT
#include "benchmark/training/core/peer_place.h"

#include <map>

#include <gmock/gmock.h>

#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

using ::testing::HasSubstr;

PeerPlace PlaceOf(const std::map<std::string, std::string>& set) {
  return PeerPlaceOf([&](const char* name) {
    const auto found = set.find(name);
    return found == set.end() ? nullptr : found->second.c_str();
  });
}

std::string ComplaintOf(const std::map<std::string, std::string>& set) {
  try {
    PlaceOf(set);
  } catch (const sim::Error& error) {
    return error.what();
  }
  return "none";
}

TEST(PeerPlace, IsAloneWithoutALauncher) {
  const PeerPlace place = PlaceOf({{"MASTER_ADDR", "somewhere"}, {"SLURM_NTASKS", "4"}});
  EXPECT_EQ(place.size, 1);
  EXPECT_EQ(place.rank, 0);
}

TEST(PeerPlace, IsWhatTorchrunSays) {
  const PeerPlace place = PlaceOf({{"RANK", "3"},
                                   {"WORLD_SIZE", "4"},
                                   {"LOCAL_WORLD_SIZE", "2"},
                                   {"MASTER_ADDR", "10.0.0.1"},
                                   {"MASTER_PORT", "1234"},
                                   {"TORCHELASTIC_USE_AGENT_STORE", "True"},
                                   {"TORCHELASTIC_RESTART_COUNT", "2"},
                                   {"BULLETNAV_PEER_TIMEOUT", "30"},
                                   {"SLURM_PROCID", "0"},
                                   {"SLURM_NTASKS", "8"}});
  EXPECT_EQ(place.rank, 3);
  EXPECT_EQ(place.size, 4);
  EXPECT_EQ(place.local_size, 2);
  EXPECT_EQ(place.address, "10.0.0.1");
  EXPECT_EQ(place.port, 1234);
  EXPECT_TRUE(place.has_store);
  EXPECT_EQ(place.round, "2");
  EXPECT_EQ(place.timeout_s, 30);
}

TEST(PeerPlace, IsWhatSlurmSays) {
  const PeerPlace place = PlaceOf(
      {{"SLURM_PROCID", "1"}, {"SLURM_NTASKS", "2"}, {"SLURM_JOB_NODELIST", "node[03-04],other"}});
  EXPECT_EQ(place.rank, 1);
  EXPECT_EQ(place.size, 2);
  EXPECT_EQ(place.address, "node03");
  EXPECT_FALSE(place.has_store);
}

TEST(PeerPlace, FindsTheFirstOfSlurmsNodes) {
  EXPECT_EQ(internal::FirstHost("alpha"), "alpha");
  EXPECT_EQ(internal::FirstHost("alpha,beta[1-2]"), "alpha");
  EXPECT_EQ(internal::FirstHost("node[7]"), "node7");
  EXPECT_EQ(internal::FirstHost("node[08,10-12]"), "node08");
}

TEST(PeerPlace, BadVariablesAreNamed) {
  EXPECT_THAT(ComplaintOf({{"RANK", "0"}}), HasSubstr("WORLD_SIZE is not set"));
  EXPECT_THAT(ComplaintOf({{"WORLD_SIZE", "2"}}), HasSubstr("RANK is not set"));
  EXPECT_THAT(ComplaintOf({{"RANK", "2"}, {"WORLD_SIZE", "2"}}), HasSubstr("from 0 to 1"));
  EXPECT_THAT(ComplaintOf({{"RANK", "0"}, {"WORLD_SIZE", "2x"}}), HasSubstr("'2x'"));
  EXPECT_THAT(ComplaintOf({{"RANK", "0"}, {"WORLD_SIZE", "2"}}), HasSubstr("MASTER_ADDR"));
  EXPECT_THAT(
      ComplaintOf(
          {{"RANK", "0"}, {"WORLD_SIZE", "2"}, {"MASTER_ADDR", "a"}, {"MASTER_PORT", "70000"}}),
      HasSubstr("MASTER_PORT"));
}

}  // namespace
}  // namespace bulletnav::bench
