// SPDX-License-Identifier: MIT
#include "benchmark/training/core/model_card.h"

#include <fmt/core.h>

#include "benchmark/base/program_version.h"

namespace bulletnav::bench {

std::string ModelCard(const TrainJob& job, int step, double seconds, const Measures& validation) {
  const Training& training = *job.training;
  std::string card = fmt::format(
      "# {}\n\n"
      "| | |\n|---|---|\n"
      "| program | bulletnav {} |\n"
      "| task | {} |\n",
      training.title(), ProgramVersion(), job.task);
  for (const auto& [name, text] : training.CardRows())
    card += fmt::format("| {} | {} |\n", name, text);
  card += fmt::format(
      "| seed | {} |\n"
      "| steps | {} of {}, {} {} in all |\n"
      "| time | {:.1f} h |\n"
      "\nOn {}:\n\n| measure | value |\n|---|---:|\n",
      job.plan.seed, step, job.plan.steps, training.FramesAfter(step), training.frames_are(),
      seconds / 3600.0, training.validated_on());
  for (const Measures::Item& item : validation.items()) {
    card += fmt::format("| {} | {:.4f} |\n", item.name, item.value);
  }
  card += "\nMade by `bulletnav train` from:\n\n```yaml\n" + job.config + "```\n";
  return card;
}

}  // namespace bulletnav::bench
