// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <vector>

#include "benchmark/episodes/drawn_grey.h"
#include "benchmark/training/supervised/dataset.h"
#include "benchmark/training/supervised/pair_batch.h"
#include "benchmark/training/supervised/scene_panoramas.h"

namespace bulletnav::bench {

/// What the batches of SceneBatches are like.
struct BatchSpec {
  int panoramas = 16;         // in each
  bool with_depth = false;    // or colour alone
  double near_batches = 0.0;  // share of them with panoramas from around one point of the scene
  std::uint64_t seed = 0;
};

/// What happens while batches are prepared; any may be empty. Called from any thread.
struct BatchesProgress {
  std::function<void(const LabelledScene&)> on_labelled;
  std::function<void()> on_loading;  // once, when all are labelled
  std::function<void()> on_loaded;   // a scene
  Warn warn;                         // of scenes that are drawn grey; from any thread
};

/// Batches from labelled scenes: each of random points of one random scene, the panoramas drawn
/// anew. Batch(number) is a function of config, seed and number. All scenes are kept in memory,
/// about 25 MB each.
class SceneBatches final : public BatchSource {
 public:
  /// Labels scenes that are not yet, and loads all of them.
  /// Throws sim::Error: see LabelScene; also if a scene has fewer points than panoramas.
  SceneBatches(const DataConfig& config, const BatchSpec& spec, const BatchesProgress& progress);

  PairBatch Batch(std::uint64_t number) const override;

 private:
  struct Scene {
    SceneSamples samples;
    std::unique_ptr<const sim::RenderScene> render;
    std::unique_ptr<ScenePanoramas> panoramas;
    std::unique_ptr<std::mutex> drawing;  // panoramas draw for one batch at a time
  };

  BatchSpec spec_;
  std::size_t pixels_;
  std::vector<Scene> scenes_;
};

}  // namespace bulletnav::bench
