// SPDX-License-Identifier: MIT
#include "python/core/world_shelf.h"

#include <algorithm>

#include "benchmark/episodes/episode_file.h"

namespace bulletnav::python {

WorldShelf::WorldShelf(const sim::WorldOptions& options, std::vector<std::filesystem::path> folders,
                       std::size_t most, bench::Warn warn)
    : cache_(options), folders_(std::move(folders)), most_(most) {
  cache_.WarnOfGrey(std::move(warn));
}

std::shared_ptr<const sim::World> WorldShelf::Get(const std::string& scene) {
  const std::filesystem::path file = bench::FindScene(scene, folders_);
  const auto place = std::find(files_.begin(), files_.end(), file);
  if (place != files_.end()) {
    files_.splice(files_.begin(), files_, place);
    return cache_.Get(file);
  }
  std::shared_ptr<const sim::World> world = cache_.Get(file);
  cache_.Expect(file);
  files_.push_front(file);
  if (files_.size() > most_) {
    cache_.Done(files_.back());
    files_.pop_back();
  }
  return world;
}

}  // namespace bulletnav::python
