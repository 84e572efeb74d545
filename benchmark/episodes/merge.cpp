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

std::set<SceneAndId> InSeveralFiles(const std::vector<NamedEpisodeSet>& files) {
  std::map<SceneAndId, std::size_t> first_file;
  std::set<SceneAndId> shared;
  for (std::size_t i = 0; i < files.size(); ++i) {
    for (const Episode& episode : files[i].set.episodes) {
      const auto place = first_file.try_emplace(KeyOf(episode), i).first;
      if (place->second != i) shared.insert(KeyOf(episode));
    }
  }
  return shared;
}

/// easy for folder/easy.json.gz.
std::string Stem(const fs::path& file) {
  const std::string name = file.filename().string();
  return name.substr(0, name.find('.', 1));
}

void RequireDistinct(const std::vector<NamedEpisodeSet>& files) {
  std::map<SceneAndId, fs::path> file_of;
  for (const NamedEpisodeSet& named : files) {
    for (const Episode& episode : named.set.episodes) {
      const auto [place, is_new] = file_of.try_emplace(KeyOf(episode), named.file);
      if (is_new) continue;
      throw sim::FileError(named.file, " episode '" + episode.id + "'",
                           "scene " + episode.scene + " has an episode of this id in " +
                               place->second.string() +
                               " too; give the files different names, or leave one out");
    }
  }
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
