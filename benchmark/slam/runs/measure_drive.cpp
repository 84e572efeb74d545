// SPDX-License-Identifier: MIT
#include "benchmark/slam/runs/measure_drive.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <utility>

namespace bulletnav::bench {
namespace {

constexpr int kRecallSteps = 50;
constexpr int kRecallDepth = 10;
constexpr int kTrueLoopEvery = 10;
constexpr double kOffMetres = 0.5;
constexpr double kOffDegrees = 10.0;

/// The best precision at each recall or more, to four digits: charts need no more, and files of
/// results stay small.
std::vector<double> PrecisionAtRecall(std::span<const PrecisionRecall> curve) {
  std::vector<double> best(kRecallSteps + 1, 0.0);
  for (const PrecisionRecall& point : curve) {
    const auto reached = static_cast<std::size_t>(std::floor(point.recall * kRecallSteps + 1e-9));
    best[reached] = std::max(best[reached], point.precision);
  }
  for (std::size_t i = best.size() - 1; i > 0; --i) best[i - 1] = std::max(best[i - 1], best[i]);
  for (double& precision : best) precision = std::round(precision * 1e4) / 1e4;
  return best;
}

RankingOutcome RankingOf(std::vector<Answer> answers, const PairCounts& pairs) {
  RankingOutcome outcome;
  outcome.loops = pairs.true_pairs;
  if (pairs.true_pairs == 0) return outcome;
  const std::vector<PrecisionRecall> curve = LoopCurve(std::move(answers), pairs);
  outcome.figures = MeasureCurve(curve, pairs);
  outcome.precision = PrecisionAtRecall(curve);
  return outcome;
}

std::vector<Answer> AnswersOf(std::span<const agent::LoopCandidate> named, const LoopTruth& truth,
                              LoopKind kind, std::optional<HeadingBin> bin) {
  std::vector<Answer> answers;
  answers.reserve(named.size());
  for (const agent::LoopCandidate& pair : named) {
    if (bin && truth.Heading(pair.later, pair.earlier) != *bin) continue;
    answers.push_back({static_cast<float>(pair.score), truth.Is(kind, pair.later, pair.earlier)});
  }
  return answers;
}

/// The ten surest pairs of each frame that has a covisible loop.
std::vector<RankedTruth> RankedQueries(std::span<const agent::LoopCandidate> named,
                                       const LoopTruth& truth) {
  std::map<int, std::vector<agent::LoopCandidate>> by_frame;
  for (const agent::LoopCandidate& pair : named) by_frame[pair.later].push_back(pair);
  std::vector<RankedTruth> queries;
  for (int later = 0; later < truth.frames(); ++later) {
    if (!truth.HasLoop(LoopKind::kCovisible, later)) continue;
    std::vector<agent::LoopCandidate>& pairs = by_frame[later];
    std::stable_sort(pairs.begin(), pairs.end(), [](const auto& a, const auto& b) {
      return a.score > b.score;
    });
    RankedTruth& ranked = queries.emplace_back();
    for (const agent::LoopCandidate& pair : pairs) {
      if (ranked.size() == kRecallDepth) break;
      ranked.push_back(truth.Is(LoopKind::kCovisible, pair.later, pair.earlier));
    }
  }
  return queries;
}

}  // namespace

void MeasureRanking(std::span<const agent::LoopCandidate> named, const LoopTruth& truth,
                    bool has_nodes, DetectorResult* result) {
  for (const LoopKind kind : kLoopKinds) {
    if (kind == LoopKind::kNode && !has_nodes) continue;
    result->rankings[std::string(NameOf(kind))] =
        RankingOf(AnswersOf(named, truth, kind, std::nullopt), {truth.Count(kind), truth.pairs()});
  }
  for (int i = 0; i < kHeadingBins; ++i) {
    const auto bin = static_cast<HeadingBin>(i);
    const PairCounts pairs = {truth.Count(LoopKind::kCovisible, bin), truth.pairs(bin)};
    result->headings[std::string(NameOf(bin))] =
        RankingOf(AnswersOf(named, truth, LoopKind::kCovisible, bin), pairs);
  }
  const std::vector<RankedTruth> queries = RankedQueries(named, truth);
  if (queries.empty()) return;
  result->recall_at_1 = RecallAt(queries, 1);
  result->recall_at_5 = RecallAt(queries, 5);
  result->recall_at_10 = RecallAt(queries, kRecallDepth);
}

BothErrors MeasureBoth(std::span<const sim::BodyPose> truth,
                       std::span<const sim::PlanarPose> estimate) {
  std::vector<sim::PlanarPose> planar;
  planar.reserve(truth.size());
  for (const sim::BodyPose& pose : truth) planar.push_back(sim::RelativePose(truth.front(), pose));
  return {MeasureTrajectory(planar, estimate, Alignment::kStart),
          MeasureTrajectory(planar, estimate, Alignment::kPlanar)};
}

bool IsOff(const MeasuredLoop& loop, std::span<const sim::BodyPose> truth) {
  const sim::PlanarPose right = sim::RelativePose(truth[static_cast<std::size_t>(loop.earlier)],
                                                  truth[static_cast<std::size_t>(loop.later)]);
  const double turned = sim::RadToDeg(std::abs(sim::WrapAngle(loop.motion.yaw - right.yaw)));
  return std::hypot(loop.motion.x - right.x, loop.motion.y - right.y) > kOffMetres ||
         turned > kOffDegrees;
}

std::vector<MeasuredLoop> TrueLoops(std::span<const TruthFrame> frames, const LoopTruth& truth) {
  std::vector<MeasuredLoop> loops;
  for (std::size_t later = 0; later < frames.size(); later += kTrueLoopEvery) {
    const int number = static_cast<int>(later);
    for (int earlier = 0; earlier < frames[later].comparable; ++earlier) {
      if (!truth.Is(LoopKind::kCovisible, number, earlier)) continue;
      loops.push_back(
          {number, earlier,
           sim::RelativePose(frames[static_cast<std::size_t>(earlier)].pose, frames[later].pose)});
      break;
    }
  }
  return loops;
}

double MillisecondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
      .count();
}

StageTimes TimesOf(std::vector<double> milliseconds) {
  if (milliseconds.empty()) return {};
  std::sort(milliseconds.begin(), milliseconds.end());
  const auto at = [&](double share) {
    const auto last = static_cast<double>(milliseconds.size() - 1);
    return milliseconds[static_cast<std::size_t>(share * last)];
  };
  return {at(0.5), at(0.95)};
}

}  // namespace bulletnav::bench
