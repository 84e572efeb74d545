// SPDX-License-Identifier: MIT
#include "benchmark/slam/runs/slam_summary.h"

#include <cstddef>

#include "benchmark/base/json_visitor.h"

namespace bulletnav::bench {
namespace {

using Results = std::vector<const DriveResult*>;

void AddTo(TrajectoryError* sum, const TrajectoryError& one) {
  sum->min += one.min;
  sum->mean += one.mean;
  sum->max += one.max;
  sum->rmse += one.rmse;
}

void DivideBy(TrajectoryError* sum, double count) {
  sum->min /= count;
  sum->mean /= count;
  sum->max /= count;
  sum->rmse /= count;
}

/// Adds drives up; `error` holds sums until they are made means.
class TrajectorySums {
 public:
  void Add(const BothErrors& error) {
    ++sums_.drives;
    AddTo(&sums_.error.start, error.start);
    AddTo(&sums_.error.planar, error.planar);
  }
  void Add(const LoopOutcome& outcome, const BothErrors& odometry) {
    sums_.accepted += outcome.accepted;
    sums_.wrong += outcome.wrong;
    if (!outcome.error) return;
    Add(*outcome.error);
    if (outcome.error->planar.mean > odometry.planar.mean) ++sums_.made_worse;
  }
  TrajectorySummary Means() const {
    TrajectorySummary means = sums_;
    if (means.drives == 0) return means;
    DivideBy(&means.error.start, means.drives);
    DivideBy(&means.error.planar, means.drives);
    return means;
  }

 private:
  TrajectorySummary sums_;
};

std::map<std::string, TrajectorySummary> MeansOf(
    const std::map<std::string, TrajectorySums>& sums) {
  std::map<std::string, TrajectorySummary> means;
  for (const auto& [length, one] : sums) means[length] = one.Means();
  return means;
}

RankingSummary SummariseRankings(const Rankings& rankings) {
  const auto mean = [&rankings](double DetectionFigures::*figure) {
    return MeanOf(rankings, [figure](const RankingOutcome& ranking) {
      return ranking.figures.*figure;
    });
  };
  RankingSummary summary;
  summary.drives = static_cast<int>(rankings.size());
  summary.figures = {.average_precision = mean(&DetectionFigures::average_precision),
                     .recall_at_1 = mean(&DetectionFigures::recall_at_1),
                     .recall_at_099 = mean(&DetectionFigures::recall_at_099),
                     .recall_at_09 = mean(&DetectionFigures::recall_at_09),
                     .guessing = mean(&DetectionFigures::guessing)};
  return summary;
}

/// The mean over drives that have it; nothing if none has.
std::optional<double> MeanShare(const Results& results, std::size_t detector,
                                std::optional<double> DetectorResult::*share) {
  double sum = 0.0;
  int count = 0;
  for (const DriveResult* result : results) {
    if (detector >= result->detectors.size()) continue;
    const std::optional<double>& value = result->detectors[detector].*share;
    if (!value) continue;
    sum += *value;
    ++count;
  }
  if (count == 0) return std::nullopt;
  return sum / count;
}

std::map<std::string, TrajectorySummary> TrajectoriesOf(const Results& results,
                                                        std::size_t detector) {
  std::map<std::string, TrajectorySums> sums;
  for (const DriveResult* result : results) {
    TrajectorySums& its = sums[LengthName(result->actions)];
    if (detector >= result->detectors.size()) continue;
    its.Add(result->detectors[detector].outcome, *result->odometry);
  }
  return MeansOf(sums);
}

DetectorSummary SummariseDetector(const std::string& name, const Results& results,
                                  std::size_t detector) {
  DetectorSummary summary;
  summary.name = name;
  summary.trajectories = TrajectoriesOf(results, detector);
  for (const LoopKind kind : {LoopKind::kCovisible, LoopKind::kNode, LoopKind::kNear}) {
    const Rankings rankings = RankingsOf(results, detector, kind);
    if (!rankings.empty()) {
      summary.rankings[std::string(NameOf(kind))] = SummariseRankings(rankings);
    }
  }
  for (int i = 0; i < kHeadingBins; ++i) {
    const auto bin = static_cast<HeadingBin>(i);
    const Rankings rankings = RankingsOf(results, detector, bin);
    if (!rankings.empty()) {
      summary.headings[std::string(NameOf(bin))] = SummariseRankings(rankings);
    }
  }
  summary.recall_at_1 = MeanShare(results, detector, &DetectorResult::recall_at_1);
  summary.recall_at_5 = MeanShare(results, detector, &DetectorResult::recall_at_5);
  summary.recall_at_10 = MeanShare(results, detector, &DetectorResult::recall_at_10);
  return summary;
}

}  // namespace

std::string LengthName(int actions) {
  return actions > 0 ? std::to_string(actions) : "recordings";
}

SlamSummary Summarise(const SlamConfig& config, std::span<const DriveResult> results) {
  SlamSummary summary;
  Results known;
  std::map<std::string, TrajectorySums> odometry;
  std::map<std::string, TrajectorySums> true_loops;
  for (const DriveResult& result : results) {
    ++summary.drives;
    if (!result.odometry) {
      ++summary.without_truth;
      continue;
    }
    known.push_back(&result);
    const std::string length = LengthName(result.actions);
    odometry[length].Add(*result.odometry);
    if (result.true_loops) true_loops[length].Add(*result.true_loops, *result.odometry);
  }
  summary.odometry = MeansOf(odometry);
  summary.true_loops = MeansOf(true_loops);
  for (std::size_t i = 0; i < config.detectors.size(); ++i) {
    summary.detectors.push_back(SummariseDetector(config.detectors[i].name, known, i));
  }
  return summary;
}

std::string ToJson(SlamSummary summary) {
  return JsonVisitor::ToJson(summary).dump(1) + "\n";
}

}  // namespace bulletnav::bench
