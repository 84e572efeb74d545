// SPDX-License-Identifier: MIT
#include "benchmark/evaluate_perception/explorable_figures.h"

#include <algorithm>

namespace bulletnav::bench {

namespace {

void AddAnswers(const SceneCases& cases, int place, std::vector<Answer>* answers) {
  const PerDirection& said = cases.explorable[static_cast<std::size_t>(place)];
  for (int i = 0; i < agent::kDirections; ++i) {
    answers->push_back({said[static_cast<std::size_t>(i)], cases.samples.IsExplorable(place, i)});
  }
}

}  // namespace

ExplorableFigures MeasureExplorable(std::span<const SceneCases> scenes, double threshold) {
  std::vector<Answer> answers;
  for (const SceneCases& cases : scenes) {
    for (int place = 0; place < cases.count(); ++place) AddAnswers(cases, place, &answers);
  }
  const auto yes = std::count_if(answers.begin(), answers.end(), [](const Answer& answer) {
    return answer.is_true;
  });
  ExplorableFigures figures;
  figures.directions = static_cast<std::int64_t>(answers.size());
  if (!answers.empty()) {
    figures.prevalence = static_cast<double>(yes) / static_cast<double>(answers.size());
  }
  figures.f1_of_yes = 2.0 * figures.prevalence / (1.0 + figures.prevalence);
  figures.average_precision = AveragePrecision(PrecisionRecallCurve(answers));
  figures.at = JudgeAnswers(answers, threshold);
  figures.thresholds = JudgeAtThresholds(answers);
  return figures;
}

}  // namespace bulletnav::bench
