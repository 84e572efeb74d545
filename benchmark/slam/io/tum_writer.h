// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>

#include "benchmark/slam/io/recorded_frame.h"

namespace bulletnav::bench {

/// Writes a recording as a TUM folder: rgb/, depth/, rgb.txt, depth.txt, calibration.txt, and
/// groundtruth.txt and odometry.txt where frames have poses.
class TumWriter final : public RecordingWriter {
 public:
  /// Throws sim::FileError if the folder holds a recording of either kind, or results.
  TumWriter(std::filesystem::path folder, const Intrinsics& intrinsics);

  void Add(const RecordedFrame& frame) override;
  void Finish() override;
  int frames() const override { return frames_; }

 private:
  std::filesystem::path folder_;
  Intrinsics intrinsics_;
  int frames_ = 0;
  std::string colors_;
  std::string depths_;
  CameraTrajectory truth_;
  CameraTrajectory odometry_;
};

}  // namespace bulletnav::bench
