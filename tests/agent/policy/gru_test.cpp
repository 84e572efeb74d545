// SPDX-License-Identifier: MIT
#include "agent/policy/gru.h"

#include <vector>

#include <gtest/gtest.h>

namespace bulletnav::agent {
namespace {

constexpr std::int64_t kSteps = 5;
constexpr std::int64_t kLanes = 3;
constexpr std::int64_t kSize = 4;

/// Of doubles, so that two ways of working out the same gradient agree closely.
struct Sequence {
  torch::Tensor inputs, memory, weight, bias;
  torch::Tensor starts = torch::zeros({kSteps, kLanes}, torch::kFloat64);

  Sequence() {
    torch::manual_seed(1);
    const auto drawn = [](at::IntArrayRef shape) {
      return torch::randn(shape, torch::kFloat64).requires_grad_();
    };
    inputs = drawn({kSteps, kLanes, 3 * kSize});
    memory = drawn({kLanes, kSize});
    weight = drawn({3 * kSize, kSize});
    bias = drawn({3 * kSize});
    starts[0][1] = 1.0;
    starts[3][0] = 1.0;
    starts[3][2] = 1.0;
  }

  torch::Tensor Run() const { return RunGru(inputs, starts, memory, weight, bias); }

  /// By torch's own cell, step by step.
  torch::Tensor RunCells() const {
    const torch::Tensor same = torch::eye(3 * kSize, torch::kFloat64);
    torch::Tensor now = memory;
    std::vector<torch::Tensor> states;
    for (std::int64_t t = 0; t < kSteps; ++t) {
      now = now * (1.0 - starts[t]).unsqueeze(1);
      now = at::gru_cell(inputs[t], now, same, weight, torch::zeros({3 * kSize}, torch::kFloat64),
                         bias);
      states.push_back(now);
    }
    return at::stack(states);
  }

  std::vector<torch::Tensor> Gradients(const torch::Tensor& states) const {
    const torch::Tensor shares = torch::linspace(-1, 2, states.numel(), torch::kFloat64);
    return torch::autograd::grad({(states.flatten() * shares).sum()},
                                 {inputs, memory, weight, bias});
  }
};

TEST(Gru, StatesAreThoseOfTorchsCells) {
  const Sequence sequence;
  EXPECT_TRUE(at::allclose(sequence.Run(), sequence.RunCells(), 0.0, 1e-12));
}

TEST(Gru, GradientsAreThoseOfTorchsCells) {
  const Sequence sequence;
  const auto own = sequence.Gradients(sequence.Run());
  const auto cells = sequence.Gradients(sequence.RunCells());
  for (std::size_t i = 0; i < own.size(); ++i) {
    EXPECT_TRUE(at::allclose(own[i], cells[i], 0.0, 1e-12)) << i;
  }
}

TEST(Gru, AStartForgetsWhatWasBefore) {
  Sequence sequence;
  const torch::Tensor states = sequence.Run();
  const auto gradient = torch::autograd::grad({states.sum()}, {sequence.memory}).front();
  EXPECT_TRUE(at::equal(gradient[1], torch::zeros({kSize}, torch::kFloat64)));
  EXPECT_GT(gradient[0].abs().min().item<double>(), 0.0);
}

TEST(Gru, StepsOneByOneAreTheSequence) {
  const torch::NoGradGuard no_grad;
  const Sequence sequence;
  const torch::Tensor all = sequence.Run();
  torch::Tensor memory = sequence.memory;
  for (std::int64_t t = 0; t < kSteps; ++t) {
    memory = RunGru(sequence.inputs.narrow(0, t, 1), sequence.starts.narrow(0, t, 1), memory,
                    sequence.weight, sequence.bias)[0];
    EXPECT_TRUE(at::allclose(memory, all[t], 0.0, 1e-12)) << t;
  }
}

TEST(Gru, GradientsGoOnlyWhereTheyAreAskedFor) {
  Sequence sequence;
  sequence.weight = sequence.weight.detach();
  sequence.memory = sequence.memory.detach();
  const auto gradient = torch::autograd::grad({sequence.Run().sum()}, {sequence.inputs}).front();
  EXPECT_GT(gradient.abs().sum().item<double>(), 0.0);
}

}  // namespace
}  // namespace bulletnav::agent
