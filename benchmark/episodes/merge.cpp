// SPDX-License-Identifier: MIT
#include "benchmark/episodes/merge.h"

#include <iterator>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;

using SceneAndId = std::pair<std::string, std::string>;

SceneAndId KeyOf(const Episode& episode) {
  return {episode.scene, episode.id};
}

/// Calls `visit(first, second, episode)` for each episode of file `second` whose scene and id an
/// earlier one of file `first` has.
template <class Visit>
void ForEachRepeat(const std::vector<NamedEpisodeSet>& files, const Visit& visit) {
  std::map<SceneAndId, std::size_t> first_file;
  for (std::size_t i = 0; i < files.size(); ++i) {
    for (const Episode& episode : files[i].set.episodes) {
      const auto [place, is_new] = first_file.try_emplace(KeyOf(episode), i);
      if (!is_new) visit(place->second, i, episode);
    }
  }
}

std::set<SceneAndId> InSeveralFiles(const std::vector<NamedEpisodeSet>& files) {
  std::set<SceneAndId> shared;
  ForEachRepeat(files, [&](std::size_t first, std::size_t second, const Episode& episode) {
    if (first != second) shared.insert(KeyOf(episode));
  });
  return shared;
}

/// easy for folder/easy.json.gz.
std::string Stem(const fs::path& file) {
  const std::string name = file.filename().string();
  return name.substr(0, name.find('.', 1));
}

void RequireDistinct(const std::vector<NamedEpisodeSet>& files) {
  ForEachRepeat(files, [&](std::size_t first, std::size_t second, const Episode& episode) {
    throw sim::FileError(files[second].file, " episode '" + episode.id + "'",
                         "scene " + episode.scene + " has an episode of this id in " +
                             files[first].file.string() +
                             " too; give the files different names, or leave one out");
  });
}

}  // namespace

MergedEpisodes MergeEpisodes(std::vector<NamedEpisodeSet> files) {
  MergedEpisodes merged;
  const std::set<SceneAndId> shared = InSeveralFiles(files);
  for (NamedEpisodeSet& named : files) {
    for (Episode& episode : named.set.episodes) {
      if (!shared.contains(KeyOf(episode))) continue;
      episode.id = Stem(named.file) + "-" + episode.id;
      ++merged.renamed;
    }
  }
  RequireDistinct(files);
  if (files.size() == 1) merged.set.other = files[0].set.other;
  for (NamedEpisodeSet& named : files) {
    auto& episodes = named.set.episodes;
    merged.set.episodes.insert(merged.set.episodes.end(), std::make_move_iterator(episodes.begin()),
                               std::make_move_iterator(episodes.end()));
  }
  return merged;
}

}  // namespace bulletnav::bench
