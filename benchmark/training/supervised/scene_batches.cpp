// SPDX-License-Identifier: MIT
#include "benchmark/training/supervised/scene_batches.h"

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>

#include "sim/base/error.h"
#include "sim/math/rng.h"
#include "sim/threads/worker_pool.h"

namespace bulletnav::bench {
namespace {

/// `count` different numbers below `below`.
std::vector<int> Draw(int count, int below, sim::Rng* rng) {
  std::vector<int> numbers(static_cast<std::size_t>(below));
  std::iota(numbers.begin(), numbers.end(), 0);
  for (int i = 0; i < count; ++i) {
    const auto j = i + rng->Below(below - i);
    std::swap(numbers[static_cast<std::size_t>(i)], numbers[static_cast<std::size_t>(j)]);
  }
  numbers.resize(static_cast<std::size_t>(count));
  return numbers;
}

/// `count` places from among the nearest to one of them, in a straight line.
std::vector<int> DrawNear(int count, const SceneSamples& samples, sim::Rng* rng) {
  constexpr int kCrowd = 4;  // times as many are near enough
  const int middle = rng->Below(samples.count());
  std::vector<int> places(static_cast<std::size_t>(samples.count()));
  std::iota(places.begin(), places.end(), 0);
  const auto distance = [&](int place) {
    return place == middle ? 0 : samples.pair(middle, place).distance;
  };
  std::stable_sort(places.begin(), places.end(), [&](int a, int b) {
    return distance(a) < distance(b);
  });
  std::vector<int> chosen = Draw(count, std::min(kCrowd * count, samples.count()), rng);
  for (int& place : chosen) place = places[static_cast<std::size_t>(place)];
  return chosen;
}

/// The labels of a pair; a place has none of the way to itself.
void AddPair(const SceneSamples& samples, int source, int goal, PairBatch* batch) {
  const PairLabel& label = samples.pair(source, goal);
  const bool is_pair = source != goal;
  const bool is_near = label.same_node != 0;
  batch->same_node.push_back(label.same_node);
  batch->direction.push_back(is_pair && is_near ? static_cast<std::int8_t>(label.direction)
                                                : std::int8_t{-1});
  batch->distance_score.push_back(is_near ? label.near_score() : 0.0f);
  for (int i = 0; i < agent::kDirections; ++i) {
    batch->scores.push_back(is_pair && !is_near ? label.far_score(i) : -1.0f);
  }
}

}  // namespace

SceneBatches::SceneBatches(const DataConfig& config, const BatchSpec& spec,
                           const BatchesProgress& progress)
    : spec_(spec), pixels_(config.panorama.pixels()) {
  std::vector<LabelledScene> labelled = LabelScenes(config, 0, progress.on_labelled);
  for (const LabelledScene& one : labelled) {
    if (one.samples.count() >= spec.panoramas) continue;
    throw sim::Error(one.file.string() + " has " + std::to_string(one.samples.count()) +
                     " labelled points, fewer than a batch of " + std::to_string(spec.panoramas));
  }
  if (progress.on_loading) progress.on_loading();
  scenes_.resize(labelled.size());
  sim::WorkerPool pool(0);
  pool.ForEach(static_cast<int>(labelled.size()), [&](int task, int /*worker*/) {
    LabelledScene& one = labelled[static_cast<std::size_t>(task)];
    Scene& scene = scenes_[static_cast<std::size_t>(task)];
    scene.samples = std::move(one.samples);
    scene.render = LoadForPanoramas(one.file, config, progress.warn);
    scene.panoramas = std::make_unique<ScenePanoramas>(*scene.render, config);
    scene.drawing = std::make_unique<std::mutex>();
    if (progress.on_loaded) progress.on_loaded();
  });
}

PairBatch SceneBatches::Batch(std::uint64_t number) const {
  sim::Rng rng = sim::Rng(spec_.seed, "training batch").Fork("number", number);
  const Scene& scene =
      scenes_[static_cast<std::size_t>(rng.Below(static_cast<int>(scenes_.size())))];
  const bool is_near = spec_.near_batches > 0.0 && rng.Chance(spec_.near_batches);
  const std::vector<int> chosen = is_near ? DrawNear(spec_.panoramas, scene.samples, &rng)
                                          : Draw(spec_.panoramas, scene.samples.count(), &rng);
  PairBatch batch;
  batch.count = spec_.panoramas;
  const auto n = static_cast<std::size_t>(spec_.panoramas);
  batch.color.resize(3 * pixels_ * n);
  if (spec_.with_depth) batch.depth.resize(pixels_ * n);
  {
    const std::lock_guard lock(*scene.drawing);
    scene.panoramas->Render(scene.samples.poses, chosen, batch.color, batch.depth);
  }
  for (const int source : chosen) {
    for (int i = 0; i < agent::kDirections; ++i) {
      batch.explorable.push_back(scene.samples.IsExplorable(source, i) ? 1 : 0);
    }
    for (const int goal : chosen) AddPair(scene.samples, source, goal, &batch);
  }
  batch.Check();
  return batch;
}

}  // namespace bulletnav::bench
