// SPDX-License-Identifier: MIT
#include "benchmark/slam/io/tum_writer.h"

#include <array>
#include <cstddef>
#include <utility>

#include <fmt/core.h>

#include "benchmark/slam/io/pictures.h"
#include "benchmark/slam/io/tum.h"
#include "sim/base/files.h"

namespace bulletnav::bench {

TumWriter::TumWriter(std::filesystem::path folder, const Intrinsics& intrinsics)
    : folder_(std::move(folder)), intrinsics_(intrinsics) {
  ExpectNoRecording(folder_);
  ExpectNoResults(folder_);
}

void TumWriter::Add(const RecordedFrame& frame) {
  const std::string name = PictureName(static_cast<std::size_t>(frames_++));
  sim::WriteFileAtomically(folder_ / "rgb" / name, sim::EncodePng(frame.color));
  sim::MakeFolder(folder_ / "depth");
  WriteTumDepth(folder_ / "depth" / name, frame.depth);
  colors_ += fmt::format("{} rgb/{}\n", frame.time, name);
  depths_ += fmt::format("{} depth/{}\n", frame.time, name);
  if (frame.truth) truth_.push_back({frame.time, *frame.truth});
  if (frame.odometry) odometry_.push_back({frame.time, *frame.odometry});
}

void TumWriter::Finish() {
  const std::array folders = {folder_ / "rgb", folder_ / "depth"};
  RemovePicturesFrom(static_cast<std::size_t>(frames_), folders);
  const Intrinsics& k = intrinsics_;
  sim::WriteFileAtomically(folder_ / "calibration.txt",
                           fmt::format("# fx fy cx cy\n{} {} {} {}\n", k.fx, k.fy, k.cx, k.cy));
  if (!truth_.empty()) sim::WriteFileAtomically(folder_ / "groundtruth.txt", ToTum(truth_));
  if (!odometry_.empty()) sim::WriteFileAtomically(folder_ / "odometry.txt", ToTum(odometry_));
  sim::WriteFileAtomically(folder_ / "depth.txt", "# t file\n" + depths_);
  sim::WriteFileAtomically(folder_ / "rgb.txt", "# t file\n" + colors_);
}

}  // namespace bulletnav::bench
