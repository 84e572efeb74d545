// SPDX-License-Identifier: MIT
#include "benchmark/slam/runs/slam_table.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include <fmt/core.h>

#include "benchmark/base/counted.h"
#include "benchmark/slam/runs/rankings.h"
#include "benchmark/slam/runs/slam_comparison.h"

namespace bulletnav::bench {
namespace {

using Results = std::vector<const DriveResult*>;

/// Of the drives that have it.
class Mean {
 public:
  void Add(double value) {
    sum_ += value;
    ++count_;
  }
  double value() const { return count_ == 0 ? 0.0 : sum_ / count_; }
  int count() const { return count_; }

 private:
  double sum_ = 0.0;
  int count_ = 0;
};

/// A row of the table of trajectories.
struct ErrorRow {
  Mean min;
  Mean mean;
  Mean max;
  Mean planar;
  int accepted = 0;
  int wrong = 0;
  int made_worse = 0;  // drives whose mean error is above odometry's

  void Add(const BothErrors& errors) {
    min.Add(errors.start.min);
    mean.Add(errors.start.mean);
    max.Add(errors.start.max);
    planar.Add(errors.planar.mean);
  }
  void Add(const LoopOutcome& outcome, const BothErrors& odometry) {
    accepted += outcome.accepted;
    wrong += outcome.wrong;
    if (!outcome.error) return;
    Add(*outcome.error);
    if (outcome.error->planar.mean > odometry.planar.mean) ++made_worse;
  }
};

std::string Line(const std::string& name, const ErrorRow& row, bool has_loops) {
  std::string line =
      fmt::format("| {} | {:.3f} | {:.3f} | {:.3f} | {:.3f} |", name, row.min.value(),
                  row.mean.value(), row.max.value(), row.planar.value());
  line += has_loops ? fmt::format(" {} | {} | {} |\n", row.accepted, row.wrong, row.made_worse)
                    : std::string("  |  |  |\n");
  return line;
}

std::string ErrorTable(const SlamConfig& config, const Results& results, int actions) {
  ErrorRow odometry;
  ErrorRow bound;
  std::vector<ErrorRow> rows(config.detectors.size());
  for (const DriveResult* result : results) {
    odometry.Add(*result->odometry);
    if (result->true_loops) bound.Add(*result->true_loops, *result->odometry);
    for (std::size_t i = 0; i < rows.size() && i < result->detectors.size(); ++i) {
      rows[i].Add(result->detectors[i].outcome, *result->odometry);
    }
  }
  const std::string what =
      actions > 0 ? fmt::format("Drives of {} actions", actions) : std::string("Recordings");
  std::string text = fmt::format(
      "{} ({}): absolute pose error in metres, each the mean over drives\n\n"
      "| | min | mean | max | mean, best laid over | loops | wrong | made worse |\n"
      "|---|---:|---:|---:|---:|---:|---:|---:|\n",
      what, results.size());
  for (const PublishedRow& row : config.published) {
    if (row.actions != actions) continue;
    text += fmt::format("| *{}* | *{:.3f}* | *{:.3f}* | *{:.3f}* |  |  |  |  |\n", row.name,
                        row.min, row.mean, row.max);
  }
  text += Line("odometry alone", odometry, false);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    text += Line(config.detectors[i].name, rows[i], true);
  }
  return text + Line("true loops", bound, true) + "\n";
}

std::string RankingLine(const std::string& name, const std::string& truth,
                        const Rankings& rankings) {
  if (rankings.empty()) return "";
  const auto mean = [&rankings](double DetectionFigures::*figure) {
    return MeanOf(rankings, [figure](const RankingOutcome& ranking) {
      return ranking.figures.*figure;
    });
  };
  return fmt::format("| {} | {} | {:.3f} | {:.3f} | {:.3f} | {:.3f} | {:.3f} |\n", name, truth,
                     mean(&DetectionFigures::guessing), mean(&DetectionFigures::average_precision),
                     mean(&DetectionFigures::recall_at_1), mean(&DetectionFigures::recall_at_099),
                     mean(&DetectionFigures::recall_at_09));
}

/// All lines of a detector.
std::string RankingLines(const std::string& name, const Results& results, std::size_t detector) {
  std::string text;
  for (const LoopKind kind : {LoopKind::kCovisible, LoopKind::kNode, LoopKind::kNear}) {
    text += RankingLine(name, std::string(NameOf(kind)), RankingsOf(results, detector, kind));
  }
  for (int i = 0; i < kHeadingBins; ++i) {
    const auto bin = static_cast<HeadingBin>(i);
    text += RankingLine(name, fmt::format("covisible, turned by {}", NameOf(bin)),
                        RankingsOf(results, detector, bin));
  }
  return text;
}

/// A cell: the mean over drives that have it.
std::string MeanShare(const Results& results, std::size_t detector,
                      std::optional<double> DetectorResult::*share) {
  Mean mean;
  for (const DriveResult* result : results) {
    if (detector >= result->detectors.size()) continue;
    if (const auto& value = result->detectors[detector].*share) mean.Add(*value);
  }
  return mean.count() == 0 ? "  |" : fmt::format(" {:.3f} |", mean.value());
}

/// How often a frame's surest pairs hold a loop; empty for results of before there was such a
/// count.
std::string QueryTable(const SlamConfig& config, const Results& results) {
  const bool has_counts = std::any_of(results.begin(), results.end(), [](const auto* result) {
    return std::any_of(result->detectors.begin(), result->detectors.end(), [](const auto& row) {
      return row.recall_at_1.has_value();
    });
  });
  if (!has_counts) return "";
  std::string text =
      "Frames that have a covisible loop: the share with one among their surest pairs\n\n"
      "| | recall@1 | @5 | @10 |\n"
      "|---|---:|---:|---:|\n";
  for (std::size_t i = 0; i < config.detectors.size(); ++i) {
    text += fmt::format("| {} |", config.detectors[i].name);
    text += MeanShare(results, i, &DetectorResult::recall_at_1);
    text += MeanShare(results, i, &DetectorResult::recall_at_5);
    text += MeanShare(results, i, &DetectorResult::recall_at_10) + "\n";
  }
  return text + "\n";
}

std::string RankingTable(const SlamConfig& config, const Results& results) {
  std::string lines;
  for (std::size_t i = 0; i < config.detectors.size(); ++i) {
    lines += RankingLines(config.detectors[i].name, results, i);
  }
  if (lines.empty()) return "No pair of frames that are compared is a loop\n";
  return "Pairs of frames, ranked by score; all that are far enough apart are compared\n\n"
         "| | loops are | guessing | AP | recall at precision 1 | at .99 | at .9 |\n"
         "|---|---|---:|---:|---:|---:|---:|\n" +
         lines + "\n" + QueryTable(config, results);
}

/// Drives of one length whose truth is known.
Results Known(std::span<const DriveResult> results, std::optional<int> actions) {
  Results known;
  for (const DriveResult& result : results) {
    if (result.odometry && (!actions || result.actions == *actions)) known.push_back(&result);
  }
  return known;
}

/// What lacks figures, and why.
std::string UnmeasuredLines(std::span<const DriveResult> results) {
  std::string text;
  std::size_t without = 0;
  for (const DriveResult& result : results) {
    if (result.odometry) continue;
    if (!result.with_truth) {
      ++without;
      continue;
    }
    text += fmt::format("{}: {} of {} frames have a true pose; figures need all\n", result.drive,
                        *result.with_truth, result.frames);
  }
  if (without > 0) {
    text += fmt::format("{} without ground truth: only their loops and trajectories are written\n",
                        Counted(without, "drive"));
  }
  return text;
}

}  // namespace

std::string SlamTables(const SlamConfig& config, std::span<const DriveResult> results) {
  std::vector<int> lengths = config.actions;
  lengths.push_back(0);
  std::string text;
  for (const int actions : lengths) {
    const Results known = Known(results, actions);
    if (!known.empty()) text += ErrorTable(config, known, actions);
  }
  const Results known = Known(results, std::nullopt);
  if (!known.empty()) {
    text += RankingTable(config, known);
    text += ComparisonTable(config, known);
    text += StageTable(config, known);
  }
  return text + UnmeasuredLines(results);
}

}  // namespace bulletnav::bench
