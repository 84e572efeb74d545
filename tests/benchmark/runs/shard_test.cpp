// SPDX-License-Identifier: MIT
#include "benchmark/runs/shard.h"

#include <algorithm>
#include <map>
#include <set>

#include <gmock/gmock.h>

#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

using testing::HasSubstr;

template <class Work>
std::string Complaint(const Work& work) {
  try {
    work();
  } catch (const sim::Error& e) {
    return e.what();
  }
  return "nothing";
}

/// As the generator draws them: by index, kind, scene.
std::vector<Episode> MakeEpisodes(int scenes, int of_each_kind, bool by_kind = false) {
  std::vector<Episode> episodes;
  for (int i = 0; i < of_each_kind; ++i) {
    for (std::size_t kind = 0; kind < 4; ++kind) {
      for (int scene = 0; scene < scenes; ++scene) {
        Episode episode;
        episode.scene = "scene" + std::to_string((7 * scene) % scenes);
        if (kind < kDifficulties.size()) episode.difficulty = kDifficulties[kind];
        episode.id = std::to_string(kind) + "-" + std::to_string(i);
        episodes.push_back(episode);
      }
    }
  }
  if (by_kind) {
    std::stable_sort(episodes.begin(), episodes.end(), [](const Episode& a, const Episode& b) {
      return a.id[0] < b.id[0];
    });
  }
  return episodes;
}

TEST(Shard, IsParsed) {
  EXPECT_EQ(ParseShard("2/8"), (Shard{2, 8}));
  EXPECT_EQ(ParseShard("1/1"), (Shard{1, 1}));
  for (const char* bad :
       {"", "2", "0/8", "9/8", "-1/8", "1/0", "a/b", "1/8x", " 1/8", "1/8/9", "1/9999999999"}) {
    EXPECT_THAT(Complaint([&] {
                  ParseShard(bad);
                }),
                HasSubstr("'" + std::string(bad) + "' is no shard"));
  }
}

std::optional<Shard> OfArray(const std::map<std::string, std::string>& variables) {
  return ShardOfArray([&](const char* name) -> const char* {
    const auto found = variables.find(name);
    return found == variables.end() ? nullptr : found->second.c_str();
  });
}

TEST(Shard, IsThatOfASlurmArray) {
  EXPECT_EQ(OfArray({}), std::nullopt);
  EXPECT_EQ(OfArray({{"SLURM_ARRAY_TASK_ID", "3"}}), std::nullopt);
  EXPECT_THROW(OfArray({{"SLURM_ARRAY_TASK_ID", "abc"}}), sim::Error);
  const auto of = [](const std::string& id, const std::string& least, const std::string& step) {
    return OfArray({{"SLURM_ARRAY_TASK_ID", id},
                    {"SLURM_ARRAY_TASK_COUNT", "4"},
                    {"SLURM_ARRAY_TASK_MIN", least},
                    {"SLURM_ARRAY_TASK_STEP", step}});
  };
  EXPECT_EQ(of("1", "1", "1"), (Shard{1, 4}));
  EXPECT_EQ(of("3", "0", "1"), (Shard{4, 4}));
  EXPECT_EQ(of("14", "10", "2"), (Shard{3, 4}));
  for (const auto& [id, least, step] : {std::tuple{"7", "1", "1"}, {"13", "10", "2"}}) {
    EXPECT_THAT(Complaint([&, i = id, l = least, s = step] {
                  of(i, l, s);
                }),
                HasSubstr("--array=1-4, or give --shard I/N"));
  }
}

/// Every episode is in one share, sizes differ by one at most, scenes are loaded as seldom as can
/// be, and no share has more than its part of a kind, but for one an end of a scene.
TEST(Shard, SharesAreEvenWithFewScenes) {
  for (const int of : {1, 2, 3, 5, 8, 40}) {
    for (const bool by_kind : {false, true}) {
      const std::vector<Episode> episodes = MakeEpisodes(6, 5, by_kind);
      std::set<std::pair<std::string, std::string>> seen;
      std::size_t loads = 0;
      for (int number = 1; number <= of; ++number) {
        const std::vector<Episode> share = ShareOf(episodes, {number, of});
        const double even = static_cast<double>(episodes.size()) / of;
        EXPECT_LT(std::abs(static_cast<double>(share.size()) - even), 1.0);
        std::set<std::string> scenes;
        std::map<std::optional<Difficulty>, int> kinds;
        for (const Episode& episode : share) {
          EXPECT_TRUE(seen.emplace(episode.scene, episode.id).second);
          scenes.insert(episode.scene);
          ++kinds[episode.difficulty];
        }
        loads += scenes.size();
        for (const auto& [kind, count] : kinds) EXPECT_LE(std::abs(count - even / 4), 2.0);
        EXPECT_EQ(ShareOf(episodes, {number, of}), share);
      }
      EXPECT_EQ(seen.size(), episodes.size());
      EXPECT_LE(loads, 6u + static_cast<std::size_t>(of) - 1u);
    }
  }
}

TEST(Shard, MoreSharesThanEpisodesLeaveSomeEmpty) {
  const std::vector<Episode> episodes = MakeEpisodes(1, 1);
  std::size_t count = 0;
  for (int number = 1; number <= 9; ++number) count += ShareOf(episodes, {number, 9}).size();
  EXPECT_EQ(count, episodes.size());
  EXPECT_TRUE(ShareOf({}, {1, 2}).empty());
}

}  // namespace
}  // namespace bulletnav::bench
