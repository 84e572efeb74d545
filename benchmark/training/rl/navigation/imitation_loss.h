// SPDX-License-Identifier: MIT
#pragma once
#include "agent/perception/torch.h"

namespace bulletnav::bench {

/// How much lessons count, by what the teacher does.
struct LessonWeights {
  double stop = 1.0;
  double forward = 1.0;
};

struct ImitationLoss {
  torch::Tensor loss;      // cross-entropy, the weighted mean over the lessons
  double agreement = 0.0;  // share of the lessons whose action is the likeliest
};

/// `log_probabilities` [steps, lanes, 4]; `lessons`: i64 [steps, lanes], the teacher's actions or
/// kNoLesson, which counts for nothing. Without a single lesson both are 0.
/// Source: Neural Topological SLAM, section 5.1; the weights are ours.
ImitationLoss ImitationLossOf(const torch::Tensor& log_probabilities, const torch::Tensor& lessons,
                              const LessonWeights& weights);

}  // namespace bulletnav::bench
