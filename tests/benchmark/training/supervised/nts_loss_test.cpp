// SPDX-License-Identifier: MIT
#include "benchmark/training/supervised/nts_loss.h"

#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "agent/perception/semantic_net.h"
#include "benchmark/training/supervised/nts_metrics.h"
#include "tests/benchmark/training/supervised/bar_world.h"

namespace bulletnav::bench {
namespace {

using agent::ModelConfig;
using agent::PairOutputs;

ModelConfig Tiny() {
  ModelConfig config;
  config.width = 8;
  config.rows = 32;
  config.pair_features = 32;
  return config;
}

/// Two pairs: the first of one node, the goal in direction 3; the second of two.
LabelledPairs TwoPairs() {
  LabelledPairs labels;
  labels.same_node = torch::tensor({1.0f, 0.0f});
  labels.direction = torch::tensor(std::vector<std::int64_t>{3, -1}, torch::kInt64);
  labels.distance_score = torch::tensor({0.5f, 0.0f});
  labels.scores = torch::full({2, 12}, 0.25f);
  labels.scores.index_put_({1, 0}, -1.0f);  // no label
  labels.scores.index_put_({1, 7}, 0.9f);
  labels.explorable = torch::zeros({2, 12});
  return labels;
}

PairOutputs TwoOutputs() {
  PairOutputs outputs;
  outputs.same_node = torch::tensor({2.0f, 1.0f});
  outputs.direction = torch::zeros({2, 12});
  outputs.distance_score = torch::tensor({0.7f, 0.9f});
  outputs.scores = torch::full({2, 12}, 0.5f);
  return outputs;
}

TEST(Losses, AreAsWorkedOutByHand) {
  const NtsLosses losses = Losses(torch::zeros({2, 12}), TwoOutputs(), TwoPairs());
  const double yes = std::log1p(std::exp(-2.0));
  const double no = std::log1p(std::exp(1.0));
  EXPECT_NEAR(losses.connection.item<double>(), 0.5 * (yes + no), 1e-5);
  EXPECT_NEAR(losses.direction.item<double>(), std::log(12.0), 1e-5);
  EXPECT_NEAR(losses.explorable.item<double>(), std::log(2.0), 1e-5);
  EXPECT_NEAR(losses.distance.item<double>(), 0.04, 1e-5);
  EXPECT_NEAR(losses.scores.item<double>(), (10 * 0.0625 + 0.16) / 11.0, 1e-5);
  EXPECT_NEAR(losses.Total().item<double>(),
              0.5 * (yes + no) + std::log(12.0) + std::log(2.0) +
                  10.0 * (0.04 + (10 * 0.0625 + 0.16) / 11.0),
              1e-4);
  const double mean_error = (10 * 0.25 - 0.4) / 11.0;
  const double contrast = (10 * 0.0625 + 0.16) / 11.0 - mean_error * mean_error;
  EXPECT_NEAR(losses.contrast.item<double>(), contrast, 1e-5);
  const auto total = [&](const NtsLosses::Weights& weights) {
    return losses.Total(weights).item<double>();
  };
  EXPECT_NEAR(total({.contrast = 20.0}) - total({}), 20.0 * contrast, 1e-4);
  EXPECT_NEAR(losses.rejection.item<double>(), 0.81, 1e-5);
  EXPECT_NEAR(total({.rejection = 3.0}) - total({}), 3.0 * 0.81, 1e-4);
}

TEST(Losses, AreZeroAndFiniteWithoutLabels) {
  LabelledPairs labels = TwoPairs();
  labels.same_node.zero_();
  labels.scores.fill_(-1.0f);
  const NtsLosses losses = Losses(torch::zeros({2, 12}), TwoOutputs(), labels);
  EXPECT_EQ(losses.direction.item<double>(), 0.0);
  EXPECT_EQ(losses.distance.item<double>(), 0.0);
  EXPECT_EQ(losses.scores.item<double>(), 0.0);
  EXPECT_TRUE(std::isfinite(losses.Total().item<double>()));
}

TEST(MetricSums, AreAsWorkedOutByHand) {
  PairOutputs outputs = TwoOutputs();
  outputs.direction.index_put_({0, 4}, 1.0f);  // one beside
  outputs.scores.index_put_({1, 0}, 0.95f);    // has no label: not a choice
  outputs.scores.index_put_({1, 7}, 0.8f);
  MetricSums sums;
  sums.Add(torch::full({2, 12}, -1.0f), outputs, TwoPairs());
  const NtsMetrics metrics = sums.Means();
  EXPECT_NEAR(metrics.connection, 0.5, 1e-9);  // yes right, no wrong
  EXPECT_EQ(metrics.direction, 0.0);
  EXPECT_EQ(metrics.direction_near, 1.0);
  EXPECT_NEAR(metrics.distance_error_m, 0.6, 1e-5);
  EXPECT_NEAR(metrics.explorable, 0.5, 1e-9);
  EXPECT_NEAR(metrics.score_error, (10 * 0.25 + 0.1) / 11.0, 1e-5);
  EXPECT_EQ(metrics.score_choice, 1.0);
}

TEST(DrawPairs, TakesHalfOfOneNodeIfThereAreAsMany) {
  tests::BarSource source(8, 1);
  const PairBatch batch = source.Batch(0);
  const auto near = [&](const std::vector<int>& pairs) {
    return std::count_if(pairs.begin(), pairs.end(), [&](int pair) {
      return batch.same_node[static_cast<std::size_t>(pair)] != 0;
    });
  };
  EXPECT_EQ(AllPairs(batch).size(), 56u);
  const auto some = DrawPairs(batch, 20, sim::Rng(1, "x"));
  EXPECT_EQ(some.size(), 20u);
  EXPECT_EQ(std::set<int>(some.begin(), some.end()).size(), 20u);
  EXPECT_EQ(near(some), 10);
  EXPECT_EQ(some, DrawPairs(batch, 20, sim::Rng(1, "x")));
  EXPECT_NE(some, DrawPairs(batch, 20, sim::Rng(2, "x")));
  EXPECT_EQ(DrawPairs(batch, 1000, sim::Rng(1, "x")), AllPairs(batch));
}

TEST(Losses, ReachEveryParameter) {
  for (const auto depth :
       {agent::DepthFusion::kNone, agent::DepthFusion::kChannel, agent::DepthFusion::kSeparate}) {
    ModelConfig config = Tiny();
    config.depth = depth;
    agent::SemanticNet net(config, 1);
    PairBatch batch =
        tests::BarBatch({{0.0, 0.0, 0.5}, {1.0, 0.5, -1.0}, {-2.5, 2.5, 2.0}, {2.5, -2.5, 3.0}});
    const LabelledPairs labels = Labels(batch, AllPairs(batch));
    const auto color = torch::from_blob(batch.color.data(), {4, 128, 512, 3}, torch::kUInt8);
    const auto metres = torch::from_blob(batch.depth.data(), {4, 128, 512}, torch::kFloat32);
    const auto parts =
        net.Describe(agent::PrepareInput(config, color, metres), at::detail::createCPUGenerator(1));
    Losses(parts.explorable, net.Compare(parts.Select(labels.source), parts.Select(labels.goal)),
           labels)
        .Total()
        .backward();
    for (const auto& item : net.named_parameters()) {
      ASSERT_TRUE(item.value().grad().defined()) << item.key();
      // All directions have it, so that their softmax does not: but for rounding it is zero.
      if (item.key() == "heads.direction_out.bias") continue;
      EXPECT_GT(item.value().grad().abs().sum().item<double>(), 0.0) << item.key();
    }
  }
}

}  // namespace
}  // namespace bulletnav::bench
