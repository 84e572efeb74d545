// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>

#include "benchmark/slam/traversal/traversal.h"

namespace bulletnav::bench {

/// Writes a traversal as a TUM folder: rgb/, depth/, rgb.txt, depth.txt, calibration.txt,
/// groundtruth.txt, and odometry.txt, in the same form: odometry added up, in a frame of its own
/// whose x is ahead of where the body began. A frame a tenth of a second.
class TumRecorder {
 public:
  /// Throws sim::FileError if the folder holds a recording already.
  TumRecorder(std::filesystem::path folder, const TraversalSpec& spec);

  void Add(const TraversalFrame& frame);
  /// Writes the lists, which make the folder a recording: one that was killed before has none.
  void Finish();

 private:
  std::filesystem::path folder_;
  TraversalSpec spec_;
  std::string colors_;
  std::string depths_;
  CameraTrajectory truth_;
  CameraTrajectory odometry_;
};

}  // namespace bulletnav::bench
