// SPDX-License-Identifier: MIT
#include "benchmark/evaluate_perception/connection_figures.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/core.h>

namespace bulletnav::bench {
namespace {

constexpr std::array kWallBins = {"0", "1", "2", "3+"};
constexpr int kCurveSteps = 100;

/// Sums of one bin.
struct BinSums {
  SceneMean accuracy;
  SceneMean recall;
  SceneMean false_positives;

  void NextScene() {
    for (SceneMean* mean : {&accuracy, &recall, &false_positives}) mean->NextScene();
  }
  void Add(bool is_true, bool says) {
    accuracy.Add(is_true == says ? 1.0 : 0.0);
    (is_true ? recall : false_positives).Add(says ? 1.0 : 0.0);
  }
  ConnectionBin Figures(std::string name, std::uint64_t seed) const {
    return {std::move(name), accuracy.Figure(seed), recall.Figure(seed),
            false_positives.Figure(seed)};
  }
};

/// All that is counted by bins.
class BinnedConnection {
 public:
  void NextScene() {
    for (BinSums& sums : distance_) sums.NextScene();
    for (BinSums& sums : walls_) sums.NextScene();
    for (BinSums& sums : walls_near_) sums.NextScene();
  }
  void Add(double distance, int walls, bool is_true, bool says) {
    const auto wall_bin = std::min(static_cast<std::size_t>(walls), kWallBins.size() - 1);
    distance_[DistanceBin(distance)].Add(is_true, says);
    walls_[wall_bin].Add(is_true, says);
    if (distance <= agent::kNodeRadius) walls_near_[wall_bin].Add(is_true, says);
  }
  void Finish(std::uint64_t seed, ConnectionFigures* figures) const {
    for (std::size_t i = 0; i < distance_.size(); ++i) {
      figures->by_distance.push_back(distance_[i].Figures(DistanceBinName(i), seed));
    }
    for (std::size_t i = 0; i < walls_.size(); ++i) {
      figures->by_walls.push_back(walls_[i].Figures(kWallBins[i], seed));
      figures->by_walls_near.push_back(walls_near_[i].Figures(kWallBins[i], seed));
    }
  }

 private:
  std::array<BinSums, kDistanceBins.size()> distance_;
  std::array<BinSums, kWallBins.size()> walls_;
  std::array<BinSums, kWallBins.size()> walls_near_;
};

}  // namespace

std::size_t DistanceBin(double metres) {
  const auto bin = std::find_if(kDistanceBins.begin(), kDistanceBins.end() - 1, [&](double end) {
    return metres < end;
  });
  return static_cast<std::size_t>(bin - kDistanceBins.begin());
}

std::string DistanceBinName(std::size_t bin) {
  const double begin = bin == 0 ? 0.0 : kDistanceBins[bin - 1];
  return std::isinf(kDistanceBins[bin]) ? fmt::format("{}+", begin)
                                        : fmt::format("{}-{}", begin, kDistanceBins[bin]);
}

ConnectionFigures MeasureConnection(std::span<const SceneCases> scenes, double threshold,
                                    std::uint64_t seed) {
  std::vector<Answer> answers;
  BinnedConnection binned;
  for (const SceneCases& cases : scenes) {
    binned.NextScene();
    ForEachPair(cases, [&](int source, int goal) {
      const PairLabel& truth = cases.samples.pair(source, goal);
      const bool is_true = truth.same_node != 0;
      const float certainty = cases.prediction(source, goal).same_node;
      answers.push_back({certainty, is_true});
      binned.Add(double{truth.distance_m()}, cases.walls_between(source, goal), is_true,
                 double{certainty} >= threshold);
    });
  }
  const auto together = std::count_if(answers.begin(), answers.end(), [](const Answer& answer) {
    return answer.is_true;
  });
  const std::vector<PrecisionRecall> curve = PrecisionRecallCurve(answers);
  ConnectionFigures figures;
  figures.pairs = static_cast<std::int64_t>(answers.size());
  if (!answers.empty()) {
    figures.prevalence = static_cast<double>(together) / static_cast<double>(answers.size());
  }
  figures.average_precision = AveragePrecision(curve);
  figures.at = JudgeAnswers(answers, threshold);
  binned.Finish(seed, &figures);
  figures.thresholds = JudgeAtThresholds(answers);
  figures.curve = Thin(curve, kCurveSteps);
  return figures;
}

}  // namespace bulletnav::bench
