// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "benchmark/episodes/episode_file.h"
#include "benchmark/episodes/generator.h"

namespace bulletnav::bench {

/// What episodes are drawn from, to be kept as EpisodeSet::other: a JSON object
///   drawn_from  object: spec, the resolved GeneratorSpec without its file and without mere looks
///               of scenes, as YAML; scenes, an object of each scene's hash.
/// Throws sim::FileError for scenes that cannot be read.
std::string DrawRecord(const GeneratorSpec& spec, const std::vector<std::string>& scenes);

/// Throws sim::FileError, naming `file` and a remedy, if the set says that it was drawn otherwise
/// or from other scenes than it would be now. Sets without a record, from elsewhere, pass.
void RequireDrawnFrom(const EpisodeSet& set, const GeneratorSpec& spec,
                      const std::filesystem::path& file);

}  // namespace bulletnav::bench
