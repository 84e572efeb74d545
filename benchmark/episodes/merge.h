// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <filesystem>
#include <vector>

#include "benchmark/episodes/episode_file.h"

namespace bulletnav::bench {

struct NamedEpisodeSet {
  std::filesystem::path file;
  EpisodeSet set;
};

struct MergedEpisodes {
  EpisodeSet set;
  std::size_t renamed = 0;
};

/// All episodes in the order of their files. Files that number their episodes from 0, one file a
/// difficulty or a split, use an id for several episodes of one scene: such an id gets the name of
/// its file in front, in every file that has it (`medium-7` for 7 of medium.json.gz). What a file
/// holds beside its episodes is kept if it is the only one.
/// Throws sim::FileError, naming both files, where that leaves two episodes with one id in a scene.
MergedEpisodes MergeEpisodes(std::vector<NamedEpisodeSet> files);

}  // namespace bulletnav::bench
