// SPDX-License-Identifier: MIT
#pragma once
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "agent/slam/loops/loop_detector.h"
#include "benchmark/slam/runs/back_end.h"
#include "benchmark/slam/runs/drive_result.h"
#include "benchmark/slam/runs/slam_config.h"
#include "sim/image/image.h"

namespace bulletnav::bench {

/// A pair that a detector took for a loop, and what became of it.
struct LoopRecord {
  int later = 0;
  int earlier = 0;
  double score = 0.0;
  int inliers = 0;            // 0: not verified
  bool is_accepted = false;   // by the back end
  bool is_covisible = false;  // by the truth, where it is known
  bool is_wrong = false;      // accepted, and its motion is off
  double turned_deg = 0.0;    // of the later camera from the earlier one, by the truth
  sim::PlanarPose motion;     // measured, if verified
};

struct PlayedDetector {
  std::string name;
  std::vector<LoopRecord> loops;
  BackEndOutcome back_end;
  agent::SequenceTrace trace;  // empty of detectors without sequences
  sim::Image similarity;       // see SimilarityMatrix
};

/// All that came of a drive.
struct PlayedDrive {
  DriveResult result;
  std::vector<double> seconds;  // when each frame was seen
  std::vector<sim::PlanarPose> odometry;
  std::vector<sim::BodyPose> truth;  // empty where it is not known
  std::vector<PlayedDetector> detectors;
  sim::Image covisible;  // by the truth, see CovisibleMatrix; empty where it is not known
  TimesByStage times;
};

/// Throws what PlayDrive would throw at the start of one of the drives: lists of recordings that
/// are broken, weights that are not there or do not fit. Scenes are not loaded.
void CheckDrives(const SlamConfig& config, std::span<const Drive> drives);

/// Drives once and shows each frame to all detectors; then verifies what they proposed, optimises
/// and measures. Detectors and back end see pictures and odometry alone. A function of config,
/// drive and vocabulary, but for the times. Throws sim::Error as DriveSource and detectors do.
/// Cost: mostly drawing, corners and verification of pairs; times.yaml of a run has the figures.
PlayedDrive PlayDrive(const SlamConfig& config, const Drive& drive,
                      std::shared_ptr<const agent::Vocabulary> vocabulary);

}  // namespace bulletnav::bench
