// SPDX-License-Identifier: MIT
#include "benchmark/training/supervised/mapper_loss.h"

#include <algorithm>
#include <span>

#include "agent/perception/model_config.h"
#include "sim/base/check.h"

namespace bulletnav::bench {

using agent::FreeSpace;

torch::Tensor FreeSpaceLabels(const PairBatch& batch, TrueFreeSpace* truth) {
  constexpr std::size_t kPixels = std::size_t{agent::kPanoramaRows} * agent::kPanoramaCols;
  BULLETNAV_CHECK_EQ(batch.depth.size(), static_cast<std::size_t>(batch.count) * kPixels);
  const torch::Tensor labels =
      torch::empty({batch.count, 2, FreeSpace::kSide, FreeSpace::kSide}, torch::kFloat32);
  float* out = labels.data_ptr<float>();
  for (int i = 0; i < batch.count; ++i) {
    const auto first = static_cast<std::size_t>(i) * kPixels;
    const FreeSpace space = truth->Predict({{}, std::span(batch.depth).subspan(first, kPixels)});
    for (const sim::Grid<float>* map : {&space.explored, &space.obstacle}) {
      out = std::copy(map->values().begin(), map->values().end(), out);
    }
  }
  return labels;
}

torch::Tensor CellsInReach() {
  const torch::Tensor mask = torch::zeros({FreeSpace::kSide, FreeSpace::kSide});
  auto cells = mask.accessor<float, 2>();
  for (int y = 0; y < FreeSpace::kSide; ++y) {
    for (int x = 0; x < FreeSpace::kSide; ++x) {
      cells[y][x] = FreeSpace::CellAt(FreeSpace::CentreOf({x, y})) ? 1.0f : 0.0f;
    }
  }
  return mask;
}

MapperLosses LossesOf(const torch::Tensor& answers, const torch::Tensor& labels,
                      double obstacle_weight) {
  const torch::Tensor reach = CellsInReach().to(answers.device());
  const auto mean = [&](int channel, const torch::Tensor& cells, double weight) {
    const torch::Tensor entropy = at::binary_cross_entropy_with_logits(
        answers.select(1, channel), labels.select(1, channel), cells,
        torch::full({1}, weight).to(answers.device()), at::Reduction::Sum);
    return entropy / cells.sum().clamp_min(1.0);
  };
  const torch::Tensor all = reach.expand_as(labels.select(1, 0));
  return {mean(0, all, 1.0), mean(1, all * labels.select(1, 0), obstacle_weight)};
}

}  // namespace bulletnav::bench
