// SPDX-License-Identifier: MIT
#include "agent/perception/heads.h"

#include <cmath>
#include <vector>

#include "agent/models/semantic_model.h"

namespace bulletnav::agent {
namespace {

constexpr int kHidden = 64;          // of the layers before the answers
constexpr double kOutputGain = 0.1;  // first answers are undecided, or sigmoids would not move
constexpr int kReach = 1;            // a patch is matched with so many neighbours to each side

/// indices[k * width + d] = (k + d + first) mod 12: twelve windows on a ring of twelve.
torch::Tensor RingWindows(int width, int first) {
  std::vector<std::int64_t> indices;
  for (int k = 0; k < kDirections; ++k) {
    for (int d = 0; d < width; ++d) {
      indices.push_back((k + d + first + kDirections) % kDirections);
    }
  }
  return torch::tensor(indices, torch::kInt64);
}

/// [n, 12, f] to [n, 12, width f]: to each place on the ring, what lies from `first` on.
torch::Tensor AroundRing(const torch::Tensor& x, int width, int first) {
  return x.index_select(1, RingWindows(width, first).to(x.device()))
      .reshape({x.size(0), kDirections, width * x.size(2)});
}

/// The last dimension, of twelve, continued by `count` of its first values.
torch::Tensor Continued(const torch::Tensor& x, int dimension, int count) {
  return at::cat({x, x.narrow(dimension, 0, count)}, dimension);
}

torch::Tensor MaximumAndMean(const torch::Tensor& x, int dimension) {
  return at::cat({x.amax(dimension), x.mean(dimension)}, -1);
}

/// Entry [i, r] of [n, 12 (i), 12 (r), ...] takes index i + r of a ring.
torch::Tensor Skewed() {
  return RingWindows(kDirections, 0);
}

}  // namespace

PanoramaParts PanoramaParts::Select(const torch::Tensor& indices) const {
  const auto pick = [&](const torch::Tensor& part) {
    return part.index_select(0, indices);
  };
  return {pick(explorable), pick(source_sum), pick(goal_sum), pick(source_match), pick(goal_match)};
}

torch::Tensor Heads::Pair::operator()(const torch::Tensor& x) const {
  return out->forward(hidden->forward(x).relu()).squeeze(-1);
}

Heads::Pair Heads::AddPair(const std::string& name, int in, sim::Rng* rng) {
  return {register_module(name + "_hidden", std::make_shared<Dense>(in, kHidden, rng)),
          register_module(name + "_out", std::make_shared<Dense>(kHidden, 1, rng, kOutputGain))};
}

Heads::Heads(const ModelConfig& config, sim::Rng* rng) : features_(config.pair_features) {
  const auto add = [&](const std::string& name, int in, int out) {
    return register_module(name, std::make_shared<Dense>(in, out, rng));
  };
  explorable_ = AddPair("explorable", 3 * kCodeSize, rng);
  source_sum_ = add("source_sum", kDirections * kCodeSize, features_);
  goal_sum_ = add("goal_sum", kDirections * kCodeSize, features_);
  source_match_ = add("source_match", kCodeSize, kMatches * kMatchSize);
  goal_match_ = add("goal_match", kCodeSize, kMatches * kMatchSize);
  matches_ = add("matches", kMatches * kDirections * (2 * kReach + 1), features_);
  second_ = add("second", features_, features_);
  direction_ = AddPair("direction", 2 * features_, rng);
  score_ = AddPair("score", 2 * features_, rng);
  connection_ = AddPair("connection", 4 * features_, rng);
  distance_ = AddPair("distance", 4 * features_, rng);
}

PanoramaParts Heads::Describe(const torch::Tensor& codes) {
  const torch::Tensor ring = AroundRing(codes, kDirections, 0);
  return {explorable_(AroundRing(codes, 3, -1)), source_sum_->forward(ring),
          goal_sum_->forward(ring), source_match_->forward(codes), goal_match_->forward(codes)};
}

torch::Tensor Heads::Matches(const torch::Tensor& source, const torch::Tensor& goal) {
  const std::int64_t count = source.size(0);
  const auto split = [&](const torch::Tensor& x) {
    return x.view({count, kDirections, kMatches, kMatchSize}).transpose(1, 2);
  };
  const torch::Tensor products =
      at::matmul(split(source), split(goal).transpose(2, 3)) / std::sqrt(double{kMatchSize});
  // by_turn[a, r] = product of the source's patch a and the goal's patch a + r.
  const torch::Tensor flat = Skewed().to(source.device());
  const torch::Tensor rows =
      torch::arange(kDirections, torch::kInt64).to(source.device()).repeat_interleave(kDirections);
  const torch::Tensor by_turn =
      products.reshape({count, kMatches, std::int64_t{kDirections} * kDirections})
          .index_select(2, rows * kDirections + flat)
          .view({count, kMatches, kDirections, kDirections});
  // Windows on the torus: twelve patches on from i, and turns around r.
  const torch::Tensor turned = by_turn.roll(kReach, 3);
  const torch::Tensor torus = Continued(Continued(turned, 3, 2 * kReach), 2, kDirections - 1);
  return torus.unfold(2, kDirections, 1)
      .unfold(3, 2 * kReach + 1, 1)
      .permute({0, 2, 3, 1, 4, 5})
      .reshape({count, kDirections, kDirections, -1});
}

PairOutputs Heads::Compare(const PanoramaParts& sources, const PanoramaParts& goals) {
  const std::int64_t count = sources.source_sum.size(0);
  const torch::Tensor goal_turned =
      goals.goal_sum.index_select(1, Skewed().to(goals.goal_sum.device()))
          .view({count, kDirections, kDirections, features_});
  const torch::Tensor sums = matches_->forward(Matches(sources.source_match, goals.goal_match)) +
                             sources.source_sum.unsqueeze(2) + goal_turned;
  const torch::Tensor both = second_->forward(sums.relu()).relu();  // [n, i, r, features]
  const torch::Tensor directions = MaximumAndMean(both, 2);
  const torch::Tensor whole = MaximumAndMean(directions, 1);
  return {connection_(whole), direction_(directions), distance_(whole).sigmoid(),
          score_(directions).sigmoid()};
}

}  // namespace bulletnav::agent
