// SPDX-License-Identifier: MIT
#include "benchmark/slam/training/place_loss.h"

#include "benchmark/slam/training/place_views.h"

namespace bulletnav::bench {
namespace {

/// log(1 + sum over `counts` of exp(x)), row by row.
torch::Tensor LogOnePlusSum(const torch::Tensor& x, const torch::Tensor& counts) {
  constexpr double kNothing = -1e4;
  const torch::Tensor kept = x.masked_fill(counts.logical_not(), kNothing);
  return at::cat({kept, torch::zeros({x.size(0), 1})}, 1).logsumexp(at::IntArrayRef{1});
}

}  // namespace

torch::Tensor SimilarityLoss(const torch::Tensor& descriptors, const torch::Tensor& covisibility,
                             const SimilarityLossSpec& spec) {
  constexpr double kFar = 10.0;  // beyond any cosine
  const torch::Tensor cosines = at::matmul(descriptors, descriptors.t());
  const torch::Tensor others = torch::eye(cosines.size(0)).to(torch::kBool).logical_not();
  const torch::Tensor same = covisibility.ge(kSamePlace).logical_and(others);
  const torch::Tensor unlike = covisibility.le(kOtherPlace).logical_and(others);
  const torch::Tensor told = cosines.detach();
  const torch::Tensor least_same =
      told.masked_fill(same.logical_not(), kFar).amin(at::IntArrayRef{1}, true);
  const torch::Tensor most_unlike =
      told.masked_fill(unlike.logical_not(), -kFar).amax(at::IntArrayRef{1}, true);
  const torch::Tensor hard_same = same.logical_and((told - spec.margin).lt(most_unlike));
  const torch::Tensor hard_unlike = unlike.logical_and((told + spec.margin).gt(least_same));
  const torch::Tensor off = cosines - spec.base;
  return (LogOnePlusSum(-spec.alpha * off, hard_same) / spec.alpha +
          LogOnePlusSum(spec.beta * off, hard_unlike) / spec.beta)
      .mean();
}

}  // namespace bulletnav::bench
