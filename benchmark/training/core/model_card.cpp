// SPDX-License-Identifier: MIT
#include "benchmark/training/core/model_card.h"

#include <fmt/core.h>

#include "benchmark/base/program_version.h"

namespace bulletnav::bench {
namespace {

std::string TableOf(const CardMeasures& measures) {
  std::string table = measures.integers
                          ? "| measure | as trained | in integers |\n|---|---:|---:|\n"
                          : "| measure | value |\n|---|---:|\n";
  for (const Measures::Item& item : measures.floats.items()) {
    table += fmt::format("| {} | {:.4f} |", item.name, item.value);
    if (measures.integers) table += fmt::format(" {:.4f} |", measures.integers->at(item.name));
    table += "\n";
  }
  return table;
}

std::string TimeOf(double seconds) {
  return seconds < 3600.0 ? fmt::format("{:.1f} min", seconds / 60.0)
                          : fmt::format("{:.1f} h", seconds / 3600.0);
}

}  // namespace

std::string ModelCard(const TrainJob& job, int step, double seconds, const CardMeasures& measures) {
  const Training& training = *job.training;
  const std::int64_t before = training.FramesBefore();
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
      "| steps | {} of {}, {} {} in all{} |\n"
      "| time | {} |\n"
      "\nOn {}:\n\n",
      job.plan.seed, step, job.plan.steps, training.FramesAfter(step), training.frames_are(),
      before == 0 ? "" : fmt::format(", on top of {}", before), TimeOf(seconds),
      training.validated_on());
  card += TableOf(measures);
  card += "\nMade by `bulletnav train` from:\n\n```yaml\n" + job.config + "```\n";
  return card;
}

}  // namespace bulletnav::bench
