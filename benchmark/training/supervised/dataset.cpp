// SPDX-License-Identifier: MIT
#include "benchmark/training/supervised/dataset.h"

#include <fmt/core.h>

#include "benchmark/training/supervised/samples_file.h"
#include "sim/base/error.h"
#include "sim/base/files.h"
#include "sim/math/rng.h"
#include "sim/threads/worker_pool.h"
#include "sim/world.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;

/// Counts up when the same scene and config come to give other labels.
constexpr std::uint64_t kLabelsVersion = 1;

std::uint64_t KeyOf(const fs::path& scene, const DataConfig& config) {
  const std::uint64_t content = sim::Hash64(sim::ReadFile(scene));
  const std::uint64_t name = sim::Hash64(scene.filename().string());  // random numbers depend on it
  return sim::MixSeed(sim::MixSeed(content, name), sim::MixSeed(LabelsKey(config), kLabelsVersion));
}

fs::path FileOf(const fs::path& scene, const DataConfig& config, std::uint64_t key) {
  return fs::path(config.cache) / fmt::format("{}-{:016x}.labels", scene.stem().string(), key);
}

}  // namespace

fs::path SamplesFile(const fs::path& scene, const DataConfig& config) {
  return FileOf(scene, config, KeyOf(scene, config));
}

LabelledScene LabelScene(const fs::path& scene, const DataConfig& config) {
  const std::uint64_t key = KeyOf(scene, config);
  const fs::path file = FileOf(scene, config, key);
  LabelledScene labelled;
  labelled.file = scene;
  if (fs::exists(file)) {
    try {
      labelled.samples = ReadSamples(file, key);
      labelled.was_cached = true;
      return labelled;
    } catch (const sim::FileError& e) {
      labelled.note = fmt::format("{}; made anew", e.what());
    }
  }
  const auto world =
      sim::World::Load(scene, {config.import.options(), config.navmesh, sim::Backend::kEmbree});
  sim::RequireFloor(scene.string(), world->report(), world->navmesh());
  labelled.samples = MakeSceneSamples(*world, config);
  WriteSamples(file, labelled.samples, key);
  return labelled;
}

std::vector<LabelledScene> LabelScenes(const DataConfig& config, int workers,
                                       const std::function<void(const LabelledScene&)>& on_scene) {
  const std::vector<fs::path> scenes = ScenesOf(config);
  std::vector<LabelledScene> labelled(scenes.size());
  sim::WorkerPool pool(workers);
  pool.ForEach(static_cast<int>(scenes.size()), [&](int task, int /*worker*/) {
    const auto s = static_cast<std::size_t>(task);
    labelled[s] = LabelScene(scenes[s], config);
    if (on_scene) on_scene(labelled[s]);
  });
  return labelled;
}

}  // namespace bulletnav::bench
