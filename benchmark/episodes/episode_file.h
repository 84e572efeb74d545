// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "benchmark/episodes/episode.h"
#include "benchmark/episodes/episode_formats.h"

namespace bulletnav::bench {

struct EpisodeSet {
  std::vector<Episode> episodes;
  /// What a file held beside its episodes: a JSON object, written back. Empty if nothing.
  std::string other;

  bool operator==(const EpisodeSet& other_set) const = default;
};

/// Reads any EpisodeFormat, .json or .json.gz whatever its name. Throws sim::FileError with one
/// line that names file, episode, place and remedy: cut off or damaged files, NaN, what is missing
/// or of the wrong type, ids given twice in a scene, no episodes.
EpisodeSet ReadEpisodes(const std::filesystem::path& file);

/// Atomically; compressed if the name ends in .gz, byte for byte the same for the same episodes.
/// Reading it again gives the same set; a file in Habitat's form comes out as it went in, with the
/// same keys in the same order and the same numbers.
void WriteEpisodes(const std::filesystem::path& file, const EpisodeSet& set,
                   EpisodeFormat format = EpisodeFormat::kHabitat);

/// Throws sim::FileError if an id appears twice in a scene. `file` is for the message.
void RequireUniqueIds(const std::vector<Episode>& episodes, const std::filesystem::path& file);

/// The mesh file of a scene as an episode names it: as it is, or below one of `folders`; there also
/// without the "data/scene_datasets/" that Habitat's sets have before some, and for X.basis.glb
/// rather X.glb, whose textures can be read. Throws sim::Error that names the places looked at.
std::filesystem::path FindScene(const std::string& scene,
                                const std::vector<std::filesystem::path>& folders);

}  // namespace bulletnav::bench
