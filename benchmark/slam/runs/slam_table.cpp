// SPDX-License-Identifier: MIT
#include "benchmark/slam/runs/slam_table.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/core.h>

#include "benchmark/base/counted.h"
#include "benchmark/slam/runs/slam_comparison.h"
#include "benchmark/slam/runs/slam_summary.h"

namespace bulletnav::bench {
namespace {

using Results = std::vector<const DriveResult*>;

std::string ErrorCells(const TrajectoryError& error) {
  return fmt::format(" {:.3f} | {:.3f} | {:.3f} | {:.3f} |", error.min, error.mean, error.max,
                     error.rmse);
}

std::string Line(const std::string& name, const TrajectorySummary& row, bool has_loops) {
  std::string line = fmt::format("| {} |{} {:.3f} | {:.3f} |", name, ErrorCells(row.error.start),
                                 row.error.planar.mean, row.error.planar.rmse);
  line += has_loops ? fmt::format(" {} | {} | {} |\n", row.accepted, row.wrong, row.made_worse)
                    : std::string("  |  |  |\n");
  return line;
}

const TrajectorySummary& Of(const std::map<std::string, TrajectorySummary>& rows,
                            const std::string& length) {
  static const TrajectorySummary none;
  const auto found = rows.find(length);
  return found == rows.end() ? none : found->second;
}

/// Trajectories of one length; empty if there are none whose truth is known.
std::string ErrorTable(const SlamConfig& config, const SlamSummary& summary, int actions) {
  const std::string length = LengthName(actions);
  const TrajectorySummary& odometry = Of(summary.odometry, length);
  if (odometry.drives == 0) return "";
  const std::string what =
      actions > 0 ? fmt::format("Drives of {} actions", actions) : std::string("Recordings");
  std::string text = fmt::format(
      "{} ({}): absolute pose error in metres, each the mean over drives\n\n"
      "| | min | mean | max | RMSE | mean, best laid over | RMSE | loops | wrong | made worse |\n"
      "|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n",
      what, odometry.drives);
  for (const PublishedRow& row : config.published) {
    if (row.actions != actions) continue;
    text += fmt::format("| *{}* | *{:.3f}* | *{:.3f}* | *{:.3f}* |  |  |  |  |  |  |\n", row.name,
                        row.min, row.mean, row.max);
  }
  text += Line("odometry alone", odometry, false);
  for (const DetectorSummary& detector : summary.detectors) {
    text += Line(detector.name, Of(detector.trajectories, length), true);
  }
  return text + Line("true loops", Of(summary.true_loops, length), true) + "\n";
}

/// Empty if no drive has such a loop.
std::string RankingLine(const std::string& name, const std::string& truth,
                        const std::map<std::string, RankingSummary>& rankings,
                        std::string_view kind) {
  const auto found = rankings.find(std::string(kind));
  if (found == rankings.end()) return "";
  const DetectionFigures& figures = found->second.figures;
  return fmt::format("| {} | {} | {:.3f} | {:.3f} | {:.3f} | {:.3f} | {:.3f} |\n", name, truth,
                     figures.guessing, figures.average_precision, figures.recall_at_1,
                     figures.recall_at_099, figures.recall_at_09);
}

/// All lines of a detector.
std::string RankingLines(const DetectorSummary& detector) {
  std::string text;
  for (const LoopKind kind : {LoopKind::kCovisible, LoopKind::kNode, LoopKind::kNear}) {
    text += RankingLine(detector.name, std::string(NameOf(kind)), detector.rankings, NameOf(kind));
  }
  for (int i = 0; i < kHeadingBins; ++i) {
    const std::string_view bin = NameOf(static_cast<HeadingBin>(i));
    text += RankingLine(detector.name, fmt::format("covisible, turned by {}", bin),
                        detector.headings, bin);
  }
  return text;
}

std::string ShareCell(const std::optional<double>& share) {
  return share ? fmt::format(" {:.3f} |", *share) : "  |";
}

/// How often a frame's surest pairs hold a loop; empty for results of before there was such a
/// count.
std::string QueryTable(const SlamSummary& summary) {
  const bool has_counts =
      std::any_of(summary.detectors.begin(), summary.detectors.end(), [](const auto& detector) {
        return detector.recall_at_1.has_value();
      });
  if (!has_counts) return "";
  std::string text =
      "Frames that have a covisible loop: the share with one among their surest pairs\n\n"
      "| | recall@1 | @5 | @10 |\n"
      "|---|---:|---:|---:|\n";
  for (const DetectorSummary& detector : summary.detectors) {
    text += fmt::format("| {} |{}{}{}\n", detector.name, ShareCell(detector.recall_at_1),
                        ShareCell(detector.recall_at_5), ShareCell(detector.recall_at_10));
  }
  return text + "\n";
}

std::string RankingTable(const SlamSummary& summary) {
  std::string lines;
  for (const DetectorSummary& detector : summary.detectors) lines += RankingLines(detector);
  if (lines.empty()) return "No pair of frames that are compared is a loop\n";
  return "Pairs of frames, ranked by score; all that are far enough apart are compared\n\n"
         "| | loops are | guessing | AP | recall at precision 1 | at .99 | at .9 |\n"
         "|---|---|---:|---:|---:|---:|---:|\n" +
         lines + "\n" + QueryTable(summary);
}

Results Measured(std::span<const DriveResult> results) {
  Results measured;
  for (const DriveResult& result : results) {
    if (result.odometry) measured.push_back(&result);
  }
  return measured;
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

/// A line of each detector whose loops no trajectory could be made of, with the first reason.
std::string TroubleLines(const SlamConfig& config, std::span<const DriveResult> results) {
  std::string text;
  for (std::size_t i = 0; i < config.detectors.size(); ++i) {
    std::size_t count = 0;
    std::string first;
    for (const DriveResult& result : results) {
      if (i >= result.detectors.size() || result.detectors[i].outcome.trouble.empty()) continue;
      if (count++ == 0) first = result.drive + ": " + result.detectors[i].outcome.trouble;
    }
    if (count == 0) continue;
    text +=
        fmt::format("{}: no trajectory could be made of the loops of {}, odometry's counts; {}\n",
                    config.detectors[i].name, Counted(count, "drive"), first);
  }
  return text;
}

/// A line of a stage; empty if no drive has it.
std::string TimesLine(const std::string& stage, std::span<const TimesByStage> times) {
  StageTimes sum;
  int count = 0;
  for (const TimesByStage& drive : times) {
    const auto found = drive.find(stage);
    if (found == drive.end()) continue;
    sum.median_ms += found->second.median_ms;
    sum.p95_ms += found->second.p95_ms;
    ++count;
  }
  if (count == 0) return "";
  return fmt::format("| {} | {:.3f} | {:.3f} |\n", stage, sum.median_ms / count,
                     sum.p95_ms / count);
}

}  // namespace

std::string SlamTables(const SlamConfig& config, std::span<const DriveResult> results) {
  const SlamSummary summary = Summarise(config, results);
  std::vector<int> lengths = config.actions;
  lengths.push_back(0);
  std::string text;
  for (const int actions : lengths) text += ErrorTable(config, summary, actions);
  const Results measured = Measured(results);
  if (!measured.empty()) {
    text += RankingTable(summary);
    text += ComparisonTable(config, measured);
    text += StageTable(config, measured);
  }
  return text + TroubleLines(config, results) + UnmeasuredLines(results);
}

std::string SlamTimesTable(const SlamConfig& config, std::span<const TimesByStage> times) {
  std::string lines = TimesLine("corners", times) + TimesLine("descriptors", times);
  for (const DetectorEntry& entry : config.detectors) {
    lines += TimesLine(entry.name, times) + TimesLine(entry.name + kAtTheEnd, times);
  }
  lines += TimesLine("verification of a pair", times);
  if (lines.empty()) return "";
  return "Milliseconds a frame on this machine: means over drives of their medians and of their "
         "95% points\n\n"
         "| | median | 95% |\n"
         "|---|---:|---:|\n" +
         lines;
}

}  // namespace bulletnav::bench
