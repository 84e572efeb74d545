// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "benchmark/runs/run_episodes.h"

namespace bulletnav::bench {
namespace {

/// `each` episodes of every difficulty in every scene, scene after scene, as others' sets have
/// them.
std::vector<Episode> Set(int scenes, int difficulties, int each) {
  std::vector<Episode> episodes;
  for (int scene = 0; scene < scenes; ++scene) {
    for (int kind = 0; kind < difficulties; ++kind) {
      for (int i = 0; i < each; ++i) {
        Episode& episode = episodes.emplace_back();
        episode.scene = "scene_" + std::to_string(scene);
        episode.id = std::to_string(kind) + "-" + std::to_string(i);
        episode.difficulty = kDifficulties[static_cast<std::size_t>(kind)];
        episode.goals.emplace_back();
      }
    }
  }
  return episodes;
}

/// Most and least often that something has been counted, of `kinds` things.
template <class Key>
int Spread(const std::map<Key, int>& counts, int kinds) {
  int least = static_cast<int>(counts.size()) < kinds ? 0 : counts.begin()->second;
  int most = 0;
  for (const auto& [key, count] : counts) {
    least = std::min(least, count);
    most = std::max(most, count);
  }
  return most - least;
}

TEST(Choose, AnyNumberIsSpreadOverScenesAndDifficulties) {
  for (const auto& [scenes, kinds] : {std::pair{1, 3}, {3, 3}, {4, 3}, {14, 3}, {5, 5}, {7, 1}}) {
    const std::vector<Episode> all = Set(scenes, kinds, 4);
    std::set<std::string> before;
    for (int n = 1; n <= static_cast<int>(all.size()); ++n) {
      const std::vector<Episode> chosen = Choose(all, {n, {}, {}});
      ASSERT_EQ(chosen.size(), static_cast<std::size_t>(n));
      std::map<std::string, int> by_scene;
      std::map<Difficulty, int> by_kind;
      std::set<std::string> names;
      for (const Episode& episode : chosen) {
        ++by_scene[episode.scene];
        ++by_kind[*episode.difficulty];
        names.insert(episode.scene + "/" + episode.id);
      }
      EXPECT_LE(Spread(by_scene, scenes), 1) << n << " of " << scenes << " x " << kinds;
      EXPECT_LE(Spread(by_kind, kinds), 2) << n << " of " << scenes << " x " << kinds;
      EXPECT_TRUE(std::includes(names.begin(), names.end(), before.begin(), before.end()));
      before = names;
    }
  }
}

TEST(Choose, KeepsTheFilesOrderAndTakesDistancesForDifficulties) {
  std::vector<Episode> all = Set(1, 3, 10);
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i].difficulty.reset();
    all[i].goals.front().geodesic_distance = i < 10 ? 2.0 : i < 20 ? 4.0 : 7.0;
  }
  const std::vector<Episode> chosen = Choose(all, {3, {}, {}});
  ASSERT_EQ(chosen.size(), 3u);
  EXPECT_EQ(chosen[0].id, "0-0");
  EXPECT_EQ(chosen[1].id, "1-0");
  EXPECT_EQ(chosen[2].id, "2-0");
  EXPECT_EQ(Choose(all, {1000, {}, {}}).size(), all.size());
}

}  // namespace
}  // namespace bulletnav::bench
