// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "agent/models/semantic_model.h"
#include "benchmark/training/supervised/dataset.h"

namespace bulletnav::bench {

using PerDirection = std::array<float, agent::kDirections>;

/// The places of one scene, what is true of them and all their ordered pairs, and what a model
/// says.
struct SceneCases {
  std::filesystem::path scene;
  SceneSamples samples;                            // places and truth
  std::vector<PerDirection> explorable;            // [n] probabilities
  std::vector<agent::PairPrediction> predictions;  // [n, n] source after source; of a place with
                                                   // itself: nothing
  std::vector<std::uint8_t> walls;                 // [n, n] between two places, see WallsBetween

  int count() const { return samples.count(); }
  const agent::PairPrediction& prediction(int source, int goal) const {
    return predictions[index(source, goal)];
  }
  agent::PairPrediction& prediction(int source, int goal) {
    return predictions[index(source, goal)];
  }
  int walls_between(int source, int goal) const { return walls[index(source, goal)]; }

 private:
  std::size_t index(int source, int goal) const {
    return static_cast<std::size_t>(source) * samples.poses.size() + static_cast<std::size_t>(goal);
  }
};

/// Calls f(cases, source, goal) for all ordered pairs of different places.
template <class F>
void ForEachPair(const SceneCases& cases, const F& f) {
  for (int source = 0; source < cases.count(); ++source) {
    for (int goal = 0; goal < cases.count(); ++goal) {
      if (source != goal) f(source, goal);
    }
  }
}

/// Makes a model of its own for each thread; may be called from several at once.
using ModelMaker = std::function<std::shared_ptr<agent::SemanticModel>()>;

struct CasesProgress {
  std::function<void()> on_place = {};                        // each compared with all others
  std::function<void(const std::string& note)> on_note = {};  // damaged labels made anew, grey
};

/// Labels all scenes of a config as for training, shows a model panoramas of their points and asks
/// it about every point and pair. One scene per worker, `workers` < 1: one per processor; the same
/// for any number. Calls to `progress` come from any thread. Throws sim::Error for scenes that
/// cannot be labelled. Cost, with the shipped model: about 4 s per scene of 60 points.
std::vector<SceneCases> MakeCases(const DataConfig& config, const ModelMaker& make_model,
                                  int workers, const CasesProgress& progress = {});

}  // namespace bulletnav::bench
