// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "benchmark/slam/metrics/detection_figures.h"
#include "benchmark/slam/metrics/trajectory_error.h"

namespace bulletnav::bench {

/// The same trajectory laid over the truth in two ways; see Alignment.
struct BothErrors {
  TrajectoryError start;
  TrajectoryError planar;

  template <class V>
  void Visit(V& v) {
    v("start", start);
    v("planar", planar);
  }
};

/// What loops did to a drive.
struct LoopOutcome {
  int proposed = 0;  // pairs that the detector takes for loops
  int verified = 0;  // of those, pairs whose corners agree on a motion
  int accepted = 0;  // of those, pairs that went into the pose graph
  int wrong = 0;     // of those, pairs whose motion is off by more than half a metre or 10 degrees
  std::optional<BothErrors> error;  // of the optimised trajectory, where the truth is known
  std::string trouble;              // why there is no optimised trajectory

  template <class V>
  void Visit(V& v) {
    v("proposed", proposed);
    v("verified", verified);
    v("accepted", accepted);
    v("wrong", wrong);
    v("error", error);
    v("trouble", trouble);
  }
};

/// How well a detector's scores rank the pairs of a drive, by a truth.
struct RankingOutcome {
  DetectionFigures figures;
  std::int64_t loops = 0;         // there are
  std::vector<double> precision;  // the best at a recall of 0, 1/50, ..., 1 or more

  template <class V>
  void Visit(V& v) {
    v("figures", figures);
    v("loops", loops);
    v("precision", precision);
  }
};

/// What the stages of a detector with sequences lose, each replaced by the truth in turn; see
/// MeasureStages. Average precisions are of covisible pairs.
struct StageOutcome {
  double compared = 0.0;     // share of all pairs that lie in joined sequences
  double within = 0.0;       // of covisible pairs: AP if their pictures were told by the truth
  double true_joins = 0.0;   // AP of the flat comparison in sequences that hold a covisible pair
  double true_places = 0.0;  // the same with runs of frames of one true place as sequences

  template <class V>
  void Visit(V& v) {
    v("compared", compared);
    v("within", within);
    v("true_joins", true_joins);
    v("true_places", true_places);
  }
};

/// One detector on one drive.
struct DetectorResult {
  std::string name;
  std::map<std::string, RankingOutcome> rankings;  // by kind of loop, see LoopKind
  /// Of covisible pairs alone, by how far the later camera is turned, see HeadingBin.
  std::map<std::string, RankingOutcome> headings;
  /// Of frames that have a covisible loop, the share with one among their surest pairs. Absent if
  /// there is no such frame; the first two in results of earlier versions, too.
  std::optional<double> recall_at_1;
  std::optional<double> recall_at_5;
  std::optional<double> recall_at_10;
  std::optional<StageOutcome> stages;
  LoopOutcome outcome;

  template <class V>
  void Visit(V& v) {
    v("name", name);
    v("rankings", rankings);
    v("headings", headings);
    v("recall_at_1", recall_at_1);
    v("recall_at_5", recall_at_5);
    v("recall_at_10", recall_at_10);
    v("stages", stages);
    v("outcome", outcome);
  }
};

/// All of one drive: what tables and charts are made from.
struct DriveResult {
  std::string drive;
  std::string scene;  // or the recording
  int actions = 0;
  int frames = 0;
  double travelled_m = 0.0;  // as odometry has it
  /// Frames whose true pose is known, if not all: then there are no figures.
  std::optional<int> with_truth;
  std::optional<BothErrors> odometry;
  std::vector<DetectorResult> detectors;
  std::optional<LoopOutcome> true_loops;  // the bound: loops and motions from the truth

  template <class V>
  void Visit(V& v) {
    v("drive", drive);
    v("scene", scene);
    v("actions", actions);
    v("frames", frames);
    v("travelled_m", travelled_m);
    v("with_truth", with_truth);
    v("odometry", odometry);
    v("detectors", detectors);
    v("true_loops", true_loops);
  }
};

/// Milliseconds a frame. Not in results: they depend on the machine.
struct StageTimes {
  double median_ms = 0.0;
  double p95_ms = 0.0;

  template <class V>
  void Visit(V& v) {
    v("median_ms", median_ms);
    v("p95_ms", p95_ms);
  }
};
/// "corners", "descriptors", "verification of a pair", and each detector by its name; what it does
/// after the last frame, shared out among all, by its name and kAtTheEnd.
inline constexpr const char* kAtTheEnd = ", at the end of the drive";
using TimesByStage = std::map<std::string, StageTimes>;

}  // namespace bulletnav::bench
