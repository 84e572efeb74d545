// SPDX-License-Identifier: MIT
#include "benchmark/training/core/model_card.h"

#include <fmt/core.h>

#include "benchmark/base/program_version.h"

namespace bulletnav::bench {

std::string ModelCard(const TrainTask& task, int step, double seconds, const Measures& validation) {
  const TrainPlan& plan = task.plan;
  std::string card = fmt::format(
      "# {}\n\n"
      "| | |\n|---|---|\n"
      "| program | bulletnav {} |\n"
      "| data | {} |\n"
      "| seed | {} |\n"
      "| steps | {} of {}, {} {} in each, {} in all |\n"
      "| time | {:.1f} h, in up to {} threads |\n",
      task.title, ProgramVersion(), task.data, plan.seed, step, plan.steps, task.frames,
      task.frames_are, step * task.frames, seconds / 3600.0, plan.lanes);
  card += fmt::format("\nOn {}:\n\n| measure | value |\n|---|---:|\n", task.validation);
  for (const Measures::Item& item : validation.items()) {
    card += fmt::format("| {} | {:.4f} |\n", item.name, item.value);
  }
  card += "\nMade by `bulletnav train` from:\n\n```yaml\n" + task.config + "```\n";
  return card;
}

}  // namespace bulletnav::bench
