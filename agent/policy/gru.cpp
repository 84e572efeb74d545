// SPDX-License-Identifier: MIT
#include "agent/policy/gru.h"

#include <cstddef>
#include <vector>

namespace bulletnav::agent {
namespace {

using torch::autograd::AutogradContext;
using torch::autograd::variable_list;

/// What the gradients need of a step, each [lanes, size].
struct Step {
  torch::Tensor before;  // memory, forgotten where an episode starts
  torch::Tensor kept;    // of the memory, for what is new
  torch::Tensor reset, update, fresh;
};

/// `inputs` and `kept`: [lanes, 3 * size].
Step Gates(const torch::Tensor& inputs, const torch::Tensor& before, const torch::Tensor& kept) {
  const std::vector<torch::Tensor> in = inputs.chunk(3, 1);
  const std::vector<torch::Tensor> of_memory = kept.chunk(3, 1);
  Step step = {before, of_memory[2], {}, {}, {}};
  step.reset = (in[0] + of_memory[0]).sigmoid();
  step.update = (in[1] + of_memory[1]).sigmoid();
  step.fresh = (in[2] + step.reset * step.kept).tanh();
  return step;
}

/// Gradients of a step from that of the memory after it.
struct StepGradients {
  torch::Tensor inputs, kept;  // [lanes, 3 * size]
  torch::Tensor before;        // [lanes, size], but for what goes through `kept`
};

StepGradients Back(const Step& step, const torch::Tensor& after) {
  const torch::Tensor fresh =
      after * (1.0 - step.update) * (1.0 - step.fresh * step.fresh);  // before tanh
  const torch::Tensor reset = fresh * step.kept * step.reset * (1.0 - step.reset);
  const torch::Tensor update =
      after * (step.before - step.fresh) * step.update * (1.0 - step.update);
  return {at::cat({reset, update, fresh}, 1), at::cat({reset, update, fresh * step.reset}, 1),
          after * step.update};
}

class Gru : public torch::autograd::Function<Gru> {
 public:
  static torch::Tensor forward(AutogradContext* context, const torch::Tensor& inputs,
                               const torch::Tensor& starts, torch::Tensor memory,
                               const torch::Tensor& weight, const torch::Tensor& bias) {
    std::vector<torch::Tensor> before, kept, reset, update, fresh, after;
    for (std::int64_t t = 0; t < inputs.size(0); ++t) {
      memory = memory * (1.0 - starts[t]).unsqueeze(1);
      const Step step = Gates(inputs[t], memory, at::linear(memory, weight, bias));
      memory = step.fresh + step.update * (memory - step.fresh);
      before.push_back(step.before);
      kept.push_back(step.kept);
      reset.push_back(step.reset);
      update.push_back(step.update);
      fresh.push_back(step.fresh);
      after.push_back(memory);
    }
    context->save_for_backward({starts, weight, at::stack(before), at::stack(kept),
                                at::stack(reset), at::stack(update), at::stack(fresh)});
    return at::stack(after);
  }

  static variable_list backward(AutogradContext* context, variable_list gradients) {
    const variable_list saved = context->get_saved_variables();
    const torch::Tensor& starts = saved[0];
    const torch::Tensor& weight = saved[1];
    const torch::Tensor& before = saved[2];
    const auto steps = static_cast<std::size_t>(before.size(0));
    std::vector<torch::Tensor> inputs(steps), kept(steps);
    torch::Tensor memory = at::zeros_like(before[0]);
    for (std::size_t i = steps; i-- > 0;) {
      const auto t = static_cast<std::int64_t>(i);
      const Step step = {before[t], saved[3][t], saved[4][t], saved[5][t], saved[6][t]};
      const StepGradients back = Back(step, gradients[0][t] + memory);
      memory = at::addmm(back.before, back.kept, weight) * (1.0 - starts[t]).unsqueeze(1);
      inputs[i] = back.inputs;
      kept[i] = back.kept;
    }
    const torch::Tensor all_kept = at::cat(kept);
    return {at::stack(inputs), {}, memory, all_kept.t().mm(before.flatten(0, 1)), all_kept.sum(0)};
  }
};

}  // namespace

torch::Tensor RunGru(const torch::Tensor& inputs, const torch::Tensor& starts,
                     const torch::Tensor& memory, const torch::Tensor& weight,
                     const torch::Tensor& bias) {
  return Gru::apply(inputs, starts, memory, weight, bias);
}

}  // namespace bulletnav::agent
