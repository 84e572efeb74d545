// SPDX-License-Identifier: MIT
#include "benchmark/slam/runs/slam_comparison.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include "benchmark/base/statistics.h"
#include "benchmark/slam/truth/loop_truth.h"

namespace bulletnav::bench {
namespace {

constexpr std::uint64_t kBootstrapSeed = 0;

/// What a detector has of a drive; nothing if there is none of it.
using Figure = std::function<std::optional<double>(const DetectorResult&)>;

struct Column {
  std::string name;
  Figure figure;
};

using ByName = std::map<std::string, RankingOutcome>;

Column Ranked(std::string name, ByName DetectorResult::*member, std::string_view key,
              double DetectionFigures::*value) {
  const auto figure =
      [=, key = std::string(key)](const DetectorResult& result) -> std::optional<double> {
    const ByName& rankings = result.*member;
    const auto found = rankings.find(key);
    if (found == rankings.end() || found->second.loops == 0) return std::nullopt;
    return found->second.figures.*value;
  };
  return {std::move(name), figure};
}

std::optional<double> ErrorOf(const DetectorResult& result) {
  if (!result.outcome.error) return std::nullopt;
  return result.outcome.error->planar.mean;
}

std::vector<Column> Columns() {
  const std::string_view covisible = NameOf(LoopKind::kCovisible);
  constexpr auto kRankings = &DetectorResult::rankings;
  constexpr auto kHeadings = &DetectorResult::headings;
  constexpr auto kPrecision = &DetectionFigures::average_precision;
  return {{Ranked("AP", kRankings, covisible, kPrecision)},
          {Ranked("turned by 90-150", kHeadings, NameOf(HeadingBin::kAcross), kPrecision)},
          {Ranked("by 150-180", kHeadings, NameOf(HeadingBin::kOpposite), kPrecision)},
          {Ranked("recall at precision 1", kRankings, covisible, &DetectionFigures::recall_at_1)},
          {Ranked("at .9", kRankings, covisible, &DetectionFigures::recall_at_09)},
          {"mean error, m, best laid over", ErrorOf}};
}

const DetectorResult* Find(const DriveResult& result, const std::string& name) {
  for (const DetectorResult& detector : result.detectors) {
    if (detector.name == name) return &detector;
  }
  return nullptr;
}

/// The mean difference of each scene.
std::vector<double> Differences(const std::vector<const DriveResult*>& results,
                                const std::string& name, const std::string& against,
                                const Figure& figure) {
  std::map<std::string, std::vector<double>> by_scene;
  for (const DriveResult* result : results) {
    const DetectorResult* one = Find(*result, name);
    const DetectorResult* other = Find(*result, against);
    if (one == nullptr || other == nullptr) continue;
    const std::optional<double> its = figure(*one);
    const std::optional<double> others = figure(*other);
    if (its && others) by_scene[result->scene].push_back(*its - *others);
  }
  std::vector<double> means;
  means.reserve(by_scene.size());
  for (const auto& [scene, differences] : by_scene) means.push_back(Mean(differences));
  return means;
}

std::string Cell(const std::vector<double>& differences) {
  if (differences.empty()) return "  |";
  const Interval interval = BootstrapInterval(differences, kBootstrapSeed);
  return fmt::format(" {:+.3f} ({:+.3f} to {:+.3f}) |", Mean(differences), interval.low,
                     interval.high);
}

}  // namespace

std::string ComparisonTable(const SlamConfig& config,
                            const std::vector<const DriveResult*>& results) {
  if (config.against.empty()) return "";
  const std::vector<Column> columns = Columns();
  std::string text =
      fmt::format("Less {}: means over scenes and 95% intervals\n\n| |", config.against);
  for (const Column& column : columns) text += fmt::format(" {} |", column.name);
  text += "\n|---|";
  for (std::size_t i = 0; i < columns.size(); ++i) text += "---:|";
  text += "\n";
  for (const DetectorEntry& entry : config.detectors) {
    if (entry.name == config.against) continue;
    text += fmt::format("| {} |", entry.name);
    for (const Column& column : columns) {
      text += Cell(Differences(results, entry.name, config.against, column.figure));
    }
    text += "\n";
  }
  return text + "\n";
}

namespace {

/// Of the drives that have it, sums of a detector's figures and of the flat comparison's.
struct StageSums {
  std::array<double, 6> values{};
  int drives = 0;

  void Add(const DetectorResult& flat, const DetectorResult& result) {
    const auto precision = [](const DetectorResult& of) {
      return of.rankings.at(std::string(NameOf(LoopKind::kCovisible))).figures.average_precision;
    };
    const StageOutcome& stages = *result.stages;
    const std::array added = {precision(flat), precision(result), stages.compared,
                              stages.within,   stages.true_joins, stages.true_places};
    for (std::size_t i = 0; i < added.size(); ++i) values[i] += added[i];
    ++drives;
  }
};

}  // namespace

std::string StageTable(const SlamConfig& config, const std::vector<const DriveResult*>& results) {
  std::string lines;
  for (const DetectorEntry& entry : config.detectors) {
    StageSums sums;
    for (const DriveResult* result : results) {
      const DetectorResult* one = Find(*result, entry.name);
      const DetectorResult* flat = Find(*result, config.against);
      if (one != nullptr && flat != nullptr && one->stages) sums.Add(*flat, *one);
    }
    if (sums.drives == 0) continue;
    lines += fmt::format("| {} |", entry.name);
    for (const double sum : sums.values) lines += fmt::format(" {:.3f} |", sum / sums.drives);
    lines += "\n";
  }
  if (lines.empty()) return "";
  return fmt::format(
             "Stages replaced by the truth: AP of covisible pairs\n\n"
             "| | {} | as it is | pairs compared | pictures by truth | sequences joined by truth | "
             "and cut by true places |\n|---|---:|---:|---:|---:|---:|---:|\n",
             config.against) +
         lines + "\n";
}

}  // namespace bulletnav::bench
