// SPDX-License-Identifier: MIT
#include "benchmark/training/model_card.h"

#include <fmt/core.h>

#include "benchmark/base/program_version.h"

namespace bulletnav::bench {
namespace {

std::string DataLine(const TrainPlan& plan) {
  if (!plan.data) return "made up by the caller";
  return fmt::format("{} scenes, {} points in each, drawn with seed {}",
                     ScenesOf(*plan.data).size(), plan.data->points, plan.data->seed);
}

}  // namespace

std::string ModelCard(const TrainTask& task, int step, double seconds, const Measures& validation) {
  const TrainPlan& plan = task.plan;
  std::string card = fmt::format(
      "# {}\n\n"
      "| | |\n|---|---|\n"
      "| program | bulletnav {} |\n"
      "| data | {} |\n"
      "| seed | {} |\n"
      "| steps | {} of {}, {} panoramas in each, {} in all |\n"
      "| time | {:.1f} h, in up to {} threads |\n",
      task.title, ProgramVersion(), DataLine(plan), plan.seed, step, plan.steps,
      plan.scenes * plan.panoramas, std::int64_t{step} * plan.scenes * plan.panoramas,
      seconds / 3600.0, plan.lanes);
  card +=
      fmt::format("\nOn {} batches of the validation scenes:\n\n| measure | value |\n|---|---:|\n",
                  plan.validation_batches);
  for (const Measures::Item& item : validation.items()) {
    card += fmt::format("| {} | {:.4f} |\n", item.name, item.value);
  }
  card += "\nMade by `bulletnav train` from:\n\n```yaml\n" + task.config + "```\n";
  return card;
}

}  // namespace bulletnav::bench
