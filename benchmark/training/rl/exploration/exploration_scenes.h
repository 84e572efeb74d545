// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

#include "benchmark/episodes/ground.h"
#include "benchmark/training/rl/exploration/height_columns.h"
#include "sim/scene/import.h"

namespace bulletnav::bench {

/// A scene to explore without pictures.
struct ExplorationScene {
  std::unique_ptr<const Ground> ground;
  std::unique_ptr<const HeightColumns> columns;  // over its largest floor
  double floor = 0.0;                            // the height of that
};

/// Throws FileError if the file is no scene, or has no floor on which a body can stand.
ExplorationScene LoadForExploration(const std::filesystem::path& file,
                                    const sim::ImportOptions& options);

/// Scenes in memory with places to start at, drawn evenly from their floors.
class ExplorationScenes {
 public:
  /// Loads all of them, `threads` at a time. `loaded` is called after each. Throws what
  /// LoadForExploration throws.
  ExplorationScenes(const std::vector<std::filesystem::path>& files,
                    const sim::ImportOptions& options, std::uint64_t seed, int threads,
                    const std::function<void()>& loaded = {});

  struct Drawn {
    const ExplorationScene* scene = nullptr;
    sim::BodyPose start;
    std::uint64_t seed = 0;  // of the episode's noise
  };
  /// Episode `number` of a lane; another for each pair.
  Drawn Draw(int lane, std::uint64_t number) const;
  /// Episode `number`, each scene in turn.
  Drawn DrawInTurn(std::uint64_t number) const;

  std::size_t count() const { return scenes_.size(); }

 private:
  Drawn DrawIn(const ExplorationScene& scene, sim::Rng rng) const;

  std::uint64_t seed_;
  std::vector<ExplorationScene> scenes_;
};

}  // namespace bulletnav::bench
