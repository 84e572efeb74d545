// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "benchmark/training/supervised/data_config.h"
#include "benchmark/training/supervised/scene_samples.h"

namespace bulletnav::bench {

/// Where the samples of a scene lie: below config.cache, named after the scene and a hash of the
/// file's bytes, its name and LabelsKey. Throws sim::FileError if the scene cannot be read.
/// What a scene refers to, such as textures, is not part of the hash.
std::filesystem::path SamplesFile(const std::filesystem::path& scene, const DataConfig& config);

struct LabelledScene {
  std::filesystem::path file;
  SceneSamples samples;
  bool was_cached = false;
  std::string note;  // one line if a damaged file was made anew; else empty
};

/// Samples of one scene, from the disk if they are there and whole; else they are made and kept.
/// Throws sim::Error for a scene that cannot be labelled, with its name.
LabelledScene LabelScene(const std::filesystem::path& scene, const DataConfig& config);

/// Labels all scenes of a config, a scene a worker, `workers` < 1: one a processor; the same for
/// any number. `on_scene` is called, from any thread, as scenes are done.
std::vector<LabelledScene> LabelScenes(const DataConfig& config, int workers,
                                       const std::function<void(const LabelledScene&)>& on_scene);

}  // namespace bulletnav::bench
