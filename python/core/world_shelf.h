// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <filesystem>
#include <list>
#include <memory>
#include <string>
#include <vector>

#include "benchmark/episodes/scene_cache.h"
#include "sim/world.h"

namespace bulletnav::python {

/// The worlds that were asked for last, by the names that episodes give their scenes. Scenes are
/// looked for as they are named and below `folders`.
class WorldShelf {
 public:
  WorldShelf(const sim::WorldOptions& options, std::vector<std::filesystem::path> folders,
             std::size_t most, bench::Warn warn = {});

  /// Throws sim::Error for a scene that is nowhere or cannot be loaded.
  std::shared_ptr<const sim::World> Get(const std::string& scene);
  /// What scenes are loaded by; imports of those whose episodes were drawn are kept for Get.
  bench::SceneCache* cache() { return &cache_; }

 private:
  bench::SceneCache cache_;
  std::vector<std::filesystem::path> folders_;
  std::size_t most_;
  std::list<std::filesystem::path> files_;  // on the shelf, the last used first
};

}  // namespace bulletnav::python
