// SPDX-License-Identifier: MIT
#include "benchmark/training/supervised/model_answers.h"

#include <array>
#include <span>
#include <vector>

namespace bulletnav::bench {
namespace {

constexpr double kSurest = 1e-6;  // of a probability, so that its logit is a number

agent::Panorama PanoramaOf(const PairBatch& batch, int index) {
  const std::size_t pixels = batch.color.size() / 3 / static_cast<std::size_t>(batch.count);
  const std::size_t first = pixels * static_cast<std::size_t>(index);
  agent::Panorama panorama;
  panorama.color = std::span(batch.color).subspan(3 * first, 3 * pixels);
  if (!batch.depth.empty()) panorama.depth = std::span(batch.depth).subspan(first, pixels);
  return panorama;
}

torch::Tensor RowOf(const std::array<float, agent::kDirections>& values) {
  return at::tensor(at::ArrayRef<float>(values.data(), values.size()));
}

torch::Tensor TensorOf(const sim::Grid<float>& grid) {
  return at::tensor(at::ArrayRef<float>(grid.values().data(), grid.values().size()))
      .view({agent::FreeSpace::kSide, agent::FreeSpace::kSide});
}

}  // namespace

ModelAnswers AnswersOf(agent::SemanticModel* model, const PairBatch& batch,
                       const LabelledPairs& pairs) {
  std::vector<agent::Panorama> panoramas;
  for (int i = 0; i < batch.count; ++i) panoramas.push_back(PanoramaOf(batch, i));
  const std::vector<agent::PanoramaCode> codes = model->Encode(panoramas);
  std::vector<torch::Tensor> explorable;
  for (const agent::PanoramaCode& code : codes)
    explorable.push_back(RowOf(model->Explorable(code)));

  std::vector<float> same_node;
  std::vector<float> distance_score;
  std::vector<torch::Tensor> direction;
  std::vector<torch::Tensor> scores;
  for (std::int64_t n = 0; n < pairs.source.size(0); ++n) {
    const auto source = static_cast<std::size_t>(pairs.source[n].item<std::int64_t>());
    const auto goal = static_cast<std::size_t>(pairs.goal[n].item<std::int64_t>());
    const std::array<const agent::PanoramaCode*, 1> sources = {&codes[source]};
    const agent::PairPrediction told = model->Compare(sources, codes[goal]).front();
    same_node.push_back(told.same_node);
    distance_score.push_back(1.0f - told.distance / static_cast<float>(agent::kNodeRadius));
    direction.push_back(RowOf(told.direction));
    scores.push_back(RowOf(told.score));
  }
  ModelAnswers answers;
  answers.explorable = at::stack(explorable).logit(kSurest);
  answers.pairs.same_node = at::tensor(same_node).logit(kSurest);
  answers.pairs.direction = at::stack(direction).clamp_min(kSurest).log();
  answers.pairs.distance_score = at::tensor(distance_score);
  answers.pairs.scores = at::stack(scores);
  return answers;
}

torch::Tensor AnswersOf(agent::FreeSpaceModel* model, const PairBatch& batch) {
  std::vector<torch::Tensor> maps;
  for (int i = 0; i < batch.count; ++i) {
    const agent::FreeSpace space = model->Predict(PanoramaOf(batch, i));
    maps.push_back(at::stack({TensorOf(space.explored), TensorOf(space.obstacle)}));
  }
  return at::stack(maps).logit(kSurest);
}

}  // namespace bulletnav::bench
