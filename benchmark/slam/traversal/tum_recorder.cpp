// SPDX-License-Identifier: MIT
#include "benchmark/slam/traversal/tum_recorder.h"

#include <utility>

#include <fmt/core.h>

#include "benchmark/slam/io/file_frames.h"
#include "sim/base/error.h"
#include "sim/base/files.h"

namespace bulletnav::bench {
TumRecorder::TumRecorder(std::filesystem::path folder, const TraversalSpec& spec)
    : folder_(std::move(folder)), spec_(spec) {
  if (std::filesystem::exists(folder_ / "rgb.txt")) {
    throw sim::FileError(folder_, "", "holds a recording already; name another folder");
  }
}

void TumRecorder::Add(const TraversalFrame& frame) {
  const double time = frame.step / kFramesASecond;
  const std::string name = fmt::format("{:06}.png", frame.step);
  sim::WriteFileAtomically(folder_ / "rgb" / name, sim::EncodePng(frame.color));
  sim::MakeFolder(folder_ / "depth");
  WriteTumDepth(folder_ / "depth" / name, frame.depth);
  colors_ += fmt::format("{} rgb/{}\n", time, name);
  depths_ += fmt::format("{} depth/{}\n", time, name);
  const double height = spec_.body.camera_height;
  truth_.push_back({time, CameraInFile(frame.true_pose, height)});
  odometry_.push_back({time, CameraInFile(frame.dead_reckoned, height)});
}

void TumRecorder::Finish() {
  const Intrinsics k = IntrinsicsOf(spec_.camera);
  sim::WriteFileAtomically(folder_ / "calibration.txt",
                           fmt::format("# fx fy cx cy\n{} {} {} {}\n", k.fx, k.fy, k.cx, k.cy));
  sim::WriteFileAtomically(folder_ / "groundtruth.txt", ToTum(truth_));
  sim::WriteFileAtomically(folder_ / "odometry.txt", ToTum(odometry_));
  sim::WriteFileAtomically(folder_ / "depth.txt", "# t file\n" + depths_);
  sim::WriteFileAtomically(folder_ / "rgb.txt", "# t file\n" + colors_);
}

}  // namespace bulletnav::bench
