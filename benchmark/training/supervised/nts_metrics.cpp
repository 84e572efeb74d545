// SPDX-License-Identifier: MIT
#include "benchmark/training/supervised/nts_metrics.h"

#include "agent/models/semantic_model.h"

namespace bulletnav::bench {
namespace {

constexpr double kChoiceSlack = 1.0 / agent::kFarthestScored;  // 1 m, as a score

}  // namespace

void MetricSums::Mean::Add(const torch::Tensor& values) {
  sum += values.sum().item<double>();
  count += static_cast<double>(values.numel());
}

void MetricSums::Balanced::Add(const torch::Tensor& logits, const torch::Tensor& truth) {
  const torch::Tensor yes = truth.gt(0.5);
  of[0].Add(logits.masked_select(yes).gt(0.0));
  of[1].Add(logits.masked_select(yes.logical_not()).le(0.0));
}

void MetricSums::Add(const torch::Tensor& explorable, const agent::PairOutputs& outputs,
                     const LabelledPairs& labels) {
  loss_.Add(Losses(explorable, outputs, labels).Total());
  connection_.Add(outputs.same_node, labels.same_node);
  explorable_.Add(explorable, labels.explorable);

  const torch::Tensor near = labels.same_node.gt(0.5);
  const torch::Tensor directed = near.logical_and(labels.direction.ge(0));
  const torch::Tensor off = (outputs.direction.argmax(1) - labels.direction)
                                .masked_select(directed)
                                .remainder(agent::kDirections);
  direction_.Add(off.eq(0));
  direction_near_.Add(off.eq(0).logical_or(off.eq(1)).logical_or(off.eq(agent::kDirections - 1)));
  const torch::Tensor score_off = (outputs.distance_score - labels.distance_score).abs();
  distance_error_.Add(score_off.masked_select(near) * agent::kNodeRadius);

  const torch::Tensor scored = near.logical_not().unsqueeze(1).logical_and(labels.scores.ge(0.0));
  score_error_.Add((outputs.scores - labels.scores).abs().masked_select(scored));
  // Only directions with a label can be chosen; a pair without any has no choice.
  const torch::Tensor choice = outputs.scores.masked_fill(scored.logical_not(), -1.0).argmax(1);
  const torch::Tensor chosen = labels.scores.gather(1, choice.unsqueeze(1)).squeeze(1);
  const torch::Tensor good = chosen.ge(labels.scores.amax(1) - kChoiceSlack);
  score_choice_.Add(good.masked_select(scored.any(1)));
}

NtsMetrics MetricSums::Means() const {
  NtsMetrics metrics;
  metrics.loss = loss_.value();
  metrics.connection = connection_.value();
  metrics.direction = direction_.value();
  metrics.direction_near = direction_near_.value();
  metrics.distance_error_m = distance_error_.value();
  metrics.explorable = explorable_.value();
  metrics.score_error = score_error_.value();
  metrics.score_choice = score_choice_.value();
  return metrics;
}

}  // namespace bulletnav::bench
