// SPDX-License-Identifier: MIT
#include "benchmark/slam/io/kitti_folder.h"

#include <array>
#include <string>
#include <utility>

#include <fmt/core.h>

#include "benchmark/base/counted.h"
#include "sim/base/error.h"
#include "sim/base/files.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;

constexpr int kLeft = 2;
constexpr int kRight = 3;

fs::path Required(const fs::path& file, std::size_t frame) {
  if (!fs::exists(file)) {
    throw sim::FileError(
        file, "",
        fmt::format("is not there, but times.txt has line {} for it; leave the line out "
                    "or add the picture",
                    frame + 1));
  }
  return file;
}

/// A trajectory with a pose a time, if the file is there.
CameraTrajectory PosesOf(const fs::path& folder, const char* name) {
  const fs::path file = folder / name;
  return fs::exists(file) ? ReadKittiTrajectory(file, folder / "times.txt") : CameraTrajectory{};
}

}  // namespace

KittiFolder ReadKittiFolder(const fs::path& folder, const std::optional<Intrinsics>& intrinsics) {
  KittiFolder read;
  read.intrinsics = intrinsics ? *intrinsics : ReadKittiCalibration(folder / "calib.txt", kLeft);
  const std::vector<double> times = ReadKittiTimes(folder / "times.txt");
  if (times.empty()) throw sim::FileError(folder / "times.txt", "", "there are no times");
  const bool has_depth = fs::exists(folder / "depth");
  if (!has_depth && !fs::exists(folder / "image_3")) {
    throw sim::FileError(folder, "",
                         "has neither depth/ nor image_3/, so depth is unknown; add one of them");
  }
  if (!has_depth) {
    read.baseline_m = ReadKittiBaseline(folder / "calib.txt", kLeft, kRight);
  }
  for (std::size_t i = 0; i < times.size(); ++i) {
    KittiFrame frame;
    frame.time = times[i];
    frame.color = Required(folder / "image_2" / PictureName(i), i);
    fs::path& other = has_depth ? frame.depth : frame.right;
    other = Required(folder / (has_depth ? "depth" : "image_3") / PictureName(i), i);
    read.frames.push_back(std::move(frame));
  }
  read.truth = PosesOf(folder, "poses.txt");
  read.odometry = PosesOf(folder, "odometry.txt");
  return read;
}

void ExpectPosesOfAllOrNone(const fs::path& place, std::size_t poses, std::size_t frames) {
  if (poses == 0 || poses == frames) return;
  throw sim::FileError(place, "",
                       fmt::format("KITTI's poses are a line a frame, but only {} of {} have one; "
                                   "export as tum instead",
                                   poses, Counted(frames, "frame")));
}

KittiWriter::KittiWriter(fs::path folder, const Intrinsics& intrinsics)
    : folder_(std::move(folder)), intrinsics_(intrinsics) {
  ExpectNoRecording(folder_);
  ExpectNoResults(folder_);
}

void KittiWriter::Add(const RecordedFrame& frame) {
  const std::string name = PictureName(times_.size());
  sim::WriteFileAtomically(folder_ / "image_2" / name, sim::EncodePng(frame.color));
  sim::MakeFolder(folder_ / "depth");
  WriteDepth(folder_ / "depth" / name, frame.depth, kKittiDepthUnits);
  times_.push_back({frame.time, {}});
  if (frame.truth) truth_.push_back({frame.time, *frame.truth});
  if (frame.odometry) odometry_.push_back({frame.time, *frame.odometry});
}

void KittiWriter::Finish() {
  const auto write = [this](const char* name, const CameraTrajectory& poses) {
    ExpectPosesOfAllOrNone(folder_ / name, poses.size(), times_.size());
    if (poses.empty()) return;
    sim::WriteFileAtomically(folder_ / name, ToKitti(poses));
  };
  const std::array folders = {folder_ / "image_2", folder_ / "depth"};
  RemovePicturesFrom(times_.size(), folders);
  write("poses.txt", truth_);
  write("odometry.txt", odometry_);
  sim::WriteFileAtomically(folder_ / "calib.txt", ToKittiCalibration(intrinsics_));
  sim::WriteFileAtomically(folder_ / "times.txt", ToKittiTimes(times_));
}

}  // namespace bulletnav::bench
