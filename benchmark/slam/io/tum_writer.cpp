// SPDX-License-Identifier: MIT
#include "benchmark/slam/io/tum_writer.h"

#include <utility>

#include <fmt/core.h>

#include "benchmark/slam/io/tum.h"
#include "sim/base/files.h"

namespace bulletnav::bench {
namespace {

std::string PictureName(int frame) {
  return fmt::format("{:06}.png", frame);
}

}  // namespace

TumWriter::TumWriter(std::filesystem::path folder, const Intrinsics& intrinsics)
    : folder_(std::move(folder)), intrinsics_(intrinsics) {
  ExpectNoRecording(folder_);
}

void TumWriter::Add(const RecordedFrame& frame) {
  const std::string name = PictureName(frames_++);
  sim::WriteFileAtomically(folder_ / "rgb" / name, sim::EncodePng(frame.color));
  sim::MakeFolder(folder_ / "depth");
  WriteTumDepth(folder_ / "depth" / name, frame.depth);
  colors_ += fmt::format("{} rgb/{}\n", frame.time, name);
  depths_ += fmt::format("{} depth/{}\n", frame.time, name);
  if (frame.truth) truth_.push_back({frame.time, *frame.truth});
  if (frame.odometry) odometry_.push_back({frame.time, *frame.odometry});
}

/// Pictures of an import into the same folder that did not come to its end.
void TumWriter::RemoveLaterPictures() const {
  for (int frame = frames_;; ++frame) {
    const std::string name = PictureName(frame);
    std::error_code ignored;  // what stays is in no list
    const bool had_color = std::filesystem::remove(folder_ / "rgb" / name, ignored);
    const bool had_depth = std::filesystem::remove(folder_ / "depth" / name, ignored);
    if (!had_color && !had_depth) return;
  }
}

void TumWriter::Finish() {
  RemoveLaterPictures();
  const Intrinsics& k = intrinsics_;
  sim::WriteFileAtomically(folder_ / "calibration.txt",
                           fmt::format("# fx fy cx cy\n{} {} {} {}\n", k.fx, k.fy, k.cx, k.cy));
  if (!truth_.empty()) sim::WriteFileAtomically(folder_ / "groundtruth.txt", ToTum(truth_));
  if (!odometry_.empty()) sim::WriteFileAtomically(folder_ / "odometry.txt", ToTum(odometry_));
  sim::WriteFileAtomically(folder_ / "depth.txt", "# t file\n" + depths_);
  sim::WriteFileAtomically(folder_ / "rgb.txt", "# t file\n" + colors_);
}

}  // namespace bulletnav::bench
