// SPDX-License-Identifier: MIT
#include "benchmark/training/supervised/nts_loss.h"

#include <algorithm>

#include "agent/models/semantic_model.h"

namespace bulletnav::bench {
namespace {

using agent::kDirections;

constexpr double kScoreWeight = 10.0;

torch::Tensor MeanWhere(const torch::Tensor& mask, const torch::Tensor& values) {
  return (values * mask).sum() / mask.sum().clamp_min(1.0);
}

torch::Tensor CrossEntropy(const torch::Tensor& logits, const torch::Tensor& truth) {
  return at::binary_cross_entropy_with_logits(logits, truth, {}, {}, at::Reduction::None);
}

/// Moves `take` of the pairs, or all there are, to `drawn`; how many are still wanted then.
int Take(int take, std::vector<int>* pairs, std::vector<int>* drawn) {
  const int n = std::min(take, static_cast<int>(pairs->size()));
  drawn->insert(drawn->end(), pairs->end() - n, pairs->end());
  pairs->resize(pairs->size() - static_cast<std::size_t>(n));
  return take - n;
}

}  // namespace

std::vector<int> AllPairs(const PairBatch& batch) {
  std::vector<int> pairs;
  for (int i = 0; i < batch.count * batch.count; ++i) {
    if (i / batch.count != i % batch.count) pairs.push_back(i);
  }
  return pairs;
}

std::vector<int> DrawPairs(const PairBatch& batch, int count_pairs, sim::Rng rng) {
  std::vector<int> near = AllPairs(batch);
  rng.Shuffle(near);
  const auto is_near = [&](int pair) {
    return batch.same_node[static_cast<std::size_t>(pair)] != 0;
  };
  const auto middle = std::stable_partition(near.begin(), near.end(), is_near);
  std::vector<int> far(middle, near.end());
  near.erase(middle, near.end());
  std::vector<int> drawn;
  const int missing = Take(count_pairs / 2, &near, &drawn);
  const int still = Take(count_pairs - count_pairs / 2 + missing, &far, &drawn);
  Take(still, &near, &drawn);
  std::sort(drawn.begin(), drawn.end());
  return drawn;
}

LabelledPairs Labels(const PairBatch& batch, const std::vector<int>& pairs) {
  const auto n = static_cast<std::int64_t>(pairs.size());
  LabelledPairs labels;
  labels.source = torch::empty({n}, torch::kInt64);
  labels.goal = torch::empty({n}, torch::kInt64);
  labels.same_node = torch::empty({n}, torch::kFloat32);
  labels.direction = torch::empty({n}, torch::kInt64);
  labels.distance_score = torch::empty({n}, torch::kFloat32);
  labels.scores = torch::empty({n, kDirections}, torch::kFloat32);
  labels.explorable = torch::empty({batch.count, kDirections}, torch::kFloat32);
  for (std::int64_t i = 0; i < n; ++i) {
    const auto pair = static_cast<std::size_t>(pairs[static_cast<std::size_t>(i)]);
    const auto count = static_cast<std::size_t>(batch.count);
    labels.source.data_ptr<std::int64_t>()[i] = static_cast<std::int64_t>(pair / count);
    labels.goal.data_ptr<std::int64_t>()[i] = static_cast<std::int64_t>(pair % count);
    labels.same_node.data_ptr<float>()[i] = batch.same_node[pair];
    labels.direction.data_ptr<std::int64_t>()[i] = batch.direction[pair];
    labels.distance_score.data_ptr<float>()[i] = batch.distance_score[pair];
    std::copy_n(batch.scores.begin() + static_cast<std::ptrdiff_t>(pair * kDirections), kDirections,
                labels.scores.data_ptr<float>() + i * kDirections);
  }
  std::copy(batch.explorable.begin(), batch.explorable.end(), labels.explorable.data_ptr<float>());
  return labels;
}

LabelledPairs Join(const std::vector<LabelledPairs>& parts) {
  const auto join = [&](torch::Tensor LabelledPairs::*member, std::int64_t step) {
    std::vector<torch::Tensor> tensors;
    for (const LabelledPairs& part : parts) {
      const auto k = static_cast<std::int64_t>(tensors.size());
      tensors.push_back(step == 0 ? part.*member : part.*member + k * step);
    }
    return at::cat(tensors);
  };
  const std::int64_t panoramas = parts.front().explorable.size(0);
  return {join(&LabelledPairs::source, panoramas), join(&LabelledPairs::goal, panoramas),
          join(&LabelledPairs::same_node, 0),      join(&LabelledPairs::direction, 0),
          join(&LabelledPairs::distance_score, 0), join(&LabelledPairs::scores, 0),
          join(&LabelledPairs::explorable, 0)};
}

torch::Tensor NtsLosses::Total(const Weights& weights) const {
  torch::Tensor total = connection + direction + explorable + kScoreWeight * (distance + scores);
  if (weights.contrast > 0.0) total = total + weights.contrast * contrast;
  if (weights.rejection > 0.0) total = total + weights.rejection * rejection;
  return total;
}

NtsLosses Losses(const torch::Tensor& explorable, const agent::PairOutputs& outputs,
                 const LabelledPairs& labels) {
  const torch::Tensor near = labels.same_node;
  const torch::Tensor far = 1.0 - near;
  const torch::Tensor connection = CrossEntropy(outputs.same_node, near);
  const torch::Tensor directed = near * labels.direction.ge(0);
  const torch::Tensor direction = -outputs.direction.log_softmax(1)
                                       .gather(1, labels.direction.clamp_min(0).unsqueeze(1))
                                       .squeeze(1);
  const torch::Tensor scored = far.unsqueeze(1) * labels.scores.ge(0.0);
  NtsLosses losses;
  losses.connection = 0.5 * (MeanWhere(near, connection) + MeanWhere(far, connection));
  losses.direction = MeanWhere(directed, direction);
  losses.explorable = CrossEntropy(explorable, labels.explorable).mean();
  losses.distance = MeanWhere(near, (outputs.distance_score - labels.distance_score).square());
  losses.rejection = MeanWhere(far, outputs.distance_score.square());
  losses.scores = MeanWhere(scored, (outputs.scores - labels.scores).square());
  const torch::Tensor error = (outputs.scores - labels.scores) * scored;
  const torch::Tensor mean =
      error.sum(1, true) / scored.to(torch::kFloat32).sum(1, true).clamp_min(1.0);
  losses.contrast = MeanWhere(scored, (error - mean).square());
  return losses;
}

}  // namespace bulletnav::bench
