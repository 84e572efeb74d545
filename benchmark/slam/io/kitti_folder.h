// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <optional>
#include <vector>

#include "benchmark/slam/io/kitti.h"
#include "benchmark/slam/io/recorded_frame.h"

namespace bulletnav::bench {

struct KittiFrame {
  double time = 0.0;
  std::filesystem::path color;  // of the left colour camera, image_2
  std::filesystem::path depth;  // empty: the right picture is there instead
  std::filesystem::path right;  // image_3
};

struct KittiFolder {
  Intrinsics intrinsics;
  double baseline_m = 0.0;  // from the left to the right camera; 0 if it is not known
  std::vector<KittiFrame> frames;
  CameraTrajectory truth;     // of each frame; empty if there is none
  CameraTrajectory odometry;  // likewise
};

/// What KITTI's depth PNGs have.
inline constexpr double kKittiDepthUnits = 256.0;

/// Reads a sequence of KITTI's odometry benchmark: calib.txt, times.txt, image_2/000000.png and so
/// on, one for each time, and depth/ (16-bit PNGs of 256 a metre) or image_3/ with the same names;
/// poses.txt, and odometry.txt, which is ours and of the same form, if they are there. No picture
/// is read. With `intrinsics` given, calib.txt is asked for the distance of stereo cameras alone,
/// and may lack where there is depth/. Poses are taken to be those of image_2's camera.
/// Throws sim::FileError as the readers in kitti.h do, for pictures that are not there, for folders
/// without depth and right pictures, and for stereo without a distance between the cameras.
KittiFolder ReadKittiFolder(const std::filesystem::path& folder,
                            const std::optional<Intrinsics>& intrinsics = {});

/// KITTI's poses have no times: a line is a frame's. Throws sim::FileError, naming `place`, if some
/// frames have a pose and others none.
void ExpectPosesOfAllOrNone(const std::filesystem::path& place, std::size_t poses,
                            std::size_t frames);

/// Writes a recording as such a folder, with depth/. Frames may lack poses, but then all lack them.
class KittiWriter final : public RecordingWriter {
 public:
  /// Throws sim::FileError if the folder holds a recording of either kind, or results.
  KittiWriter(std::filesystem::path folder, const Intrinsics& intrinsics);

  void Add(const RecordedFrame& frame) override;
  /// Throws sim::FileError if some frames have a pose and others none.
  void Finish() override;
  int frames() const override { return static_cast<int>(times_.size()); }

 private:
  std::filesystem::path folder_;
  Intrinsics intrinsics_;
  CameraTrajectory times_;  // poses are not used
  CameraTrajectory truth_;
  CameraTrajectory odometry_;
};

}  // namespace bulletnav::bench
