// SPDX-License-Identifier: MIT
#include "benchmark/training/supervised/calibration.h"

#include <vector>

#include "benchmark/training/supervised/batch_tensors.h"
#include "benchmark/training/supervised/dataset.h"
#include "benchmark/training/supervised/scene_panoramas.h"

namespace bulletnav::bench {

torch::Tensor CalibrationInput(const DataConfig& config, const agent::ModelConfig& model) {
  std::vector<std::uint8_t> color(3 * config.panorama.pixels());
  std::vector<float> depth(config.panorama.pixels());
  const agent::Panorama panorama = {color, depth};
  std::vector<torch::Tensor> inputs;
  for (const std::filesystem::path& scene : ScenesOf(config)) {
    const SceneSamples samples = LabelScene(scene, config).samples;
    const auto render = LoadForPanoramas(scene, config);
    ScenePanoramas panoramas(*render, config);
    for (int place = 0; place < samples.count(); ++place) {
      panoramas.Render(samples.poses, {&place, 1}, color, depth);
      inputs.push_back(agent::PrepareInput(model, panorama));
    }
  }
  return at::cat(inputs);
}

torch::Tensor CalibrationInput(const BatchSource& batches, const agent::ModelConfig& model) {
  constexpr int kEnough = 384;
  std::vector<torch::Tensor> inputs;
  int count = 0;
  for (std::uint64_t number = 0; count < kEnough; ++number) {
    PairBatch batch = batches.Batch(number);
    count += batch.count;
    inputs.push_back(InputOf(model, &batch));
  }
  return at::cat(inputs);
}

}  // namespace bulletnav::bench
