// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "benchmark/slam/io/pictures.h"
#include "benchmark/slam/io/trajectory.h"

namespace bulletnav::bench {

/// Reads lines "t x y z qx qy qz qw". Throws sim::FileError with the line: not so many words, no
/// finite numbers, quaternions of another length, times that do not rise; or no line at all.
/// Source: Sturm et al., "A benchmark for the evaluation of RGB-D SLAM systems", IROS 2012.
CameraTrajectory ReadTumTrajectory(const std::filesystem::path& file);
std::string ToTum(const CameraTrajectory& trajectory);

/// A picture of a list, rgb.txt or depth.txt.
struct TimedFile {
  double time = 0.0;
  std::filesystem::path file;
  int line = 0;  // of the list
};

/// Reads lines "t file", files below the list's folder. Throws sim::FileError with the line: as
/// above, and files that are not there.
std::vector<TimedFile> ReadTumList(const std::filesystem::path& list);

/// Pairs of positions whose times differ by at most `most` seconds, nearest first come, each in at
/// most one pair; by rising first position. Times of each rise. Cost: pairs within `most`, sorted.
std::vector<std::pair<int, int>> NearestTimes(std::span<const double> first,
                                              std::span<const double> second, double most);

/// The pose that is nearest in time to each of `times`, where there is one within `most` seconds.
std::vector<std::optional<agent::SpatialPose>> PosesAt(std::span<const double> times,
                                                       const CameraTrajectory& trajectory,
                                                       double most);

/// Seconds between a frame and its pose, at most.
inline constexpr double kPoseApart = 0.05;

/// The true poses of a recording's frames within kPoseApart, read from `file`. Throws
/// sim::FileError if there are poses, but none of any frame.
std::vector<std::optional<agent::SpatialPose>> TruthAt(std::span<const double> times,
                                                       const CameraTrajectory& truth,
                                                       const std::filesystem::path& file);

struct TumFrame {
  double time = 0.0;  // of the colour picture
  std::filesystem::path color;
  std::filesystem::path depth;
};

struct TumFolder {
  Intrinsics intrinsics;
  std::vector<TumFrame> frames;
  int left_out = 0;        // colour pictures without one of depth
  CameraTrajectory truth;  // groundtruth.txt; empty if there is none
};

struct TumOptions {
  double most_apart = 0.02;  // seconds between a colour and a depth picture of one frame
  std::optional<Intrinsics> intrinsics = {};
};

/// Reads rgb.txt, depth.txt, calibration.txt, which is ours: one line "fx fy cx cy", unless the
/// intrinsics are given, and groundtruth.txt if there is one; no picture.
/// Throws sim::FileError: as above, intrinsics that are unknown or not positive, and fewer than
/// half of the colour pictures with one of depth.
TumFolder ReadTumFolder(const std::filesystem::path& folder, const TumOptions& options);

/// 16-bit PNGs of 5000 a metre. What does not fit, 13.1 m and more, is written as none.
/// Reading throws sim::FileError for other files, and writing if it fails.
DepthPicture ReadTumDepth(const std::filesystem::path& file);
void WriteTumDepth(const std::filesystem::path& file, const DepthPicture& picture);

}  // namespace bulletnav::bench
