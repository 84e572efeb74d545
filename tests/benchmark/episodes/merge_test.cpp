// SPDX-License-Identifier: MIT
#include "benchmark/episodes/merge.h"

#include <string>
#include <utility>

#include <gmock/gmock.h>

#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

NamedEpisodeSet File(const char* name,
                     const std::vector<std::pair<const char*, const char*>>& scenes_and_ids) {
  NamedEpisodeSet file{name, {}};
  for (const auto& [scene, id] : scenes_and_ids) {
    Episode episode;
    episode.scene = scene;
    episode.id = id;
    file.set.episodes.push_back(episode);
  }
  file.set.other = R"({"episodes":null,"from":")" + std::string(name) + "\"}";
  return file;
}

std::vector<std::string> Ids(const MergedEpisodes& merged) {
  std::vector<std::string> ids;
  for (const Episode& episode : merged.set.episodes) ids.push_back(episode.id);
  return ids;
}

TEST(MergeEpisodes, OneFileStaysAsItIs) {
  const NamedEpisodeSet file = File("easy.json", {{"a", "0"}, {"b", "0"}, {"a", "1"}});
  const MergedEpisodes merged = MergeEpisodes({file});
  EXPECT_EQ(merged.set, file.set);
  EXPECT_EQ(merged.renamed, 0u);
}

TEST(MergeEpisodes, IdsOfSeveralFilesGetTheFilesNames) {
  const MergedEpisodes merged =
      MergeEpisodes({File("val/easy.json.gz", {{"a", "0"}, {"b", "0"}, {"a", "1"}}),
                     File("val/hard.json.gz", {{"a", "0"}, {"b", "7"}, {"c", "1"}})});
  EXPECT_THAT(Ids(merged), ElementsAre("easy-0", "0", "1", "hard-0", "7", "1"));
  EXPECT_EQ(merged.renamed, 2u);
  EXPECT_EQ(merged.set.other, "");
}

TEST(MergeEpisodes, IdsThatStayEqualAreRefusedWithBothFiles) {
  const auto complaint = [](std::vector<NamedEpisodeSet> files) -> std::string {
    try {
      MergeEpisodes(std::move(files));
    } catch (const sim::FileError& e) {
      return e.what();
    }
    return "none";
  };
  EXPECT_THAT(
      complaint({File("train/easy.json", {{"a", "0"}}), File("val/easy.json", {{"a", "0"}})}),
      AllOf(HasSubstr("val/easy.json"), HasSubstr("train/easy.json"), HasSubstr("'easy-0'")));
  EXPECT_THAT(complaint({File("easy.json", {{"a", "0"}, {"a", "hard-0"}}),
                         File("hard.json", {{"a", "0"}})}),
              AllOf(HasSubstr("easy.json"), HasSubstr("hard.json")));
}

}  // namespace
}  // namespace bulletnav::bench
