// SPDX-License-Identifier: MIT
#include "benchmark/training/core/training_scenes.h"

#include <set>

#include "benchmark/episodes/generator.h"
#include "sim/base/error.h"

namespace bulletnav::bench {

namespace fs = std::filesystem;

void DataHouses::Validate() const {
  if (count < 0 || count > 9999) {
    throw sim::KeyError("count", "count must lie between 0 and 9999");
  }
  if (count > 0 && fs::path(index).filename() != "index.json") {
    throw sim::KeyError("index", "houses are generated with an index.json; name that");
  }
}

void TrainingScenes::Validate() const {
  if (!scenes.empty() || houses || more_houses) return;
  throw sim::Error("names no scenes; give 'scenes', 'houses' or 'more_houses'");
}

void MakeHousesOf(const TrainingScenes& scenes, const std::string& made_by, int workers,
                  const StartProgress& start) {
  if (scenes.houses && scenes.houses->count > 0 && !fs::exists(scenes.houses->index)) {
    const fs::path folder = fs::path(scenes.houses->index).parent_path();
    MakeHouses({folder.empty() ? "." : folder.string(), scenes.houses->count}, made_by, workers,
               start);
  }
  if (scenes.more_houses) MakeHouses(*scenes.more_houses, made_by, workers, start);
}

std::vector<fs::path> ScenesOf(const TrainingScenes& scenes) {
  GeneratorSpec spec;
  spec.scenes = scenes.scenes;
  if (scenes.houses) spec.houses = HouseSelection{scenes.houses->index, scenes.houses->split};
  const std::vector<std::string> named = ScenesOf(spec);
  std::vector<fs::path> files(named.begin(), named.end());
  if (scenes.more_houses) {
    const std::vector<fs::path> more = FilesOf(*scenes.more_houses);
    files.insert(files.end(), more.begin(), more.end());
  }
  std::set<fs::path> known;
  for (const fs::path& file : files) {
    if (known.insert(fs::absolute(file).lexically_normal()).second) continue;
    throw sim::FileError(file, "", "is named twice; name each scene once");
  }
  return files;
}

}  // namespace bulletnav::bench
