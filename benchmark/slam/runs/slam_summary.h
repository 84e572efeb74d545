// SPDX-License-Identifier: MIT
#pragma once
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "benchmark/slam/runs/drive_result.h"
#include "benchmark/slam/runs/rankings.h"
#include "benchmark/slam/runs/slam_config.h"

namespace bulletnav::bench {

/// Where a trajectory was off, means over drives, and what loops it was made from.
struct TrajectorySummary {
  int drives = 0;  // that have the trajectory; the errors are their means, in metres
  BothErrors error;
  int accepted = 0;    // loops of all drives
  int wrong = 0;       // of those
  int made_worse = 0;  // drives whose mean error, best laid over, is above odometry's

  template <class V>
  void Visit(V& v) {
    v("drives", drives);
    v("error", error);
    v("accepted", accepted);
    v("wrong", wrong);
    v("made_worse", made_worse);
  }
};

/// How well a detector ranks, means over the drives that have a loop.
struct RankingSummary {
  int drives = 0;
  DetectionFigures figures;

  template <class V>
  void Visit(V& v) {
    v("drives", drives);
    v("figures", figures);
  }
};

/// One detector over all drives.
struct DetectorSummary {
  std::string name;
  std::map<std::string, TrajectorySummary> trajectories;  // by actions of a drive
  std::map<std::string, RankingSummary> rankings;         // by kind of loop, see LoopKind
  std::map<std::string, RankingSummary> headings;         // of covisible pairs, see HeadingBin
  std::optional<double> recall_at_1;  // of frames that have a loop, see DetectorResult
  std::optional<double> recall_at_5;
  std::optional<double> recall_at_10;

  template <class V>
  void Visit(V& v) {
    v("name", name);
    v("trajectories", trajectories);
    v("rankings", rankings);
    v("headings", headings);
    v("recall_at_1", recall_at_1);
    v("recall_at_5", recall_at_5);
    v("recall_at_10", recall_at_10);
  }
};

/// All of a run, for tables and summary.json.
struct SlamSummary {
  int drives = 0;
  int without_truth = 0;                              // of those: they count nowhere else
  std::map<std::string, TrajectorySummary> odometry;  // by actions of a drive
  std::map<std::string, TrajectorySummary> true_loops;
  std::vector<DetectorSummary> detectors;

  template <class V>
  void Visit(V& v) {
    v("drives", drives);
    v("without_truth", without_truth);
    v("odometry", odometry);
    v("true_loops", true_loops);
    v("detectors", detectors);
  }
};

/// By what trajectories are told apart: the number of actions, "recordings" for 0.
std::string LengthName(int actions);

/// Of drives whose truth is known; those of all lengths together in rankings.
SlamSummary Summarise(const SlamConfig& config, std::span<const DriveResult> results);

/// The text of summary.json.
std::string ToJson(SlamSummary summary);

}  // namespace bulletnav::bench
