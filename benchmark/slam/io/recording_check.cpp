// SPDX-License-Identifier: MIT
#include "benchmark/slam/io/recording_check.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

/// Of focal lengths, in widths of a picture: fields of view of 176 and of .3 degrees.
constexpr double kLeastFocal = 0.02;
constexpr double kMostFocal = 200.0;

}  // namespace

std::string SizeText(int width_px, int height_px) {
  return fmt::format("{} x {}", width_px, height_px);
}

RecordingCheck::RecordingCheck(std::filesystem::path folder, const Intrinsics& intrinsics)
    : folder_(std::move(folder)), intrinsics_(intrinsics) {}

void RecordingCheck::TakeFirst(const std::filesystem::path& file, const sim::Image& color) {
  constexpr int kLeast = 8;
  const std::string size = SizeText(color.width, color.height);
  if (std::min(color.width, color.height) < kLeast) {
    throw sim::FileError(file, "",
                         fmt::format("is of {} pixels; corners need pictures of at least {}", size,
                                     SizeText(kLeast, kLeast)));
  }
  const Intrinsics& k = intrinsics_;
  const bool is_inside = k.cx > 0.0 && k.cx < color.width && k.cy > 0.0 && k.cy < color.height;
  if (!is_inside) {
    throw sim::FileError(
        folder_, "",
        fmt::format("the principal point {}, {} lies outside of pictures of {} pixels; import it "
                    "with the intrinsics of these pictures, --intrinsics fx,fy,cx,cy",
                    k.cx, k.cy, size));
  }
  const auto is_odd = [&](double focal) {
    return focal < kLeastFocal * color.width || focal > kMostFocal * color.width;
  };
  if (is_odd(k.fx) || is_odd(k.fy)) {
    throw sim::FileError(folder_, "",
                         fmt::format("focal lengths of {} and {} pixels are of no camera with "
                                     "pictures of {}; import it with --intrinsics fx,fy,cx,cy",
                                     k.fx, k.fy, size));
  }
  width_ = color.width;
  height_ = color.height;
}

void RecordingCheck::TakeColor(const std::filesystem::path& file, const sim::Image& color) {
  if (width_ == 0) TakeFirst(file, color);
  if (color.width != width_ || color.height != height_) {
    throw sim::FileError(
        file, "",
        fmt::format("is of {} pixels, the first picture of {}; all frames must "
                    "come from one camera",
                    SizeText(color.width, color.height), SizeText(width_, height_)));
  }
  color_ = file;
}

void RecordingCheck::TakeDepth(const std::filesystem::path& file, const DepthPicture& depth) {
  if (depth.width != width_ || depth.height != height_) {
    throw sim::FileError(
        file, "",
        fmt::format("is of {} pixels, but {} of {}; bring depth to the colour camera's pixels",
                    SizeText(depth.width, depth.height), color_.string(),
                    SizeText(width_, height_)));
  }
  has_depth_ = has_depth_ || std::any_of(depth.metres.begin(), depth.metres.end(), [](float m) {
                 return m > 0.0F;
               });
}

void RecordingCheck::Finish() const {
  if (has_depth_) return;
  throw sim::FileError(folder_, "",
                       "no picture has any depth; depth PNGs must be of 16 bits, and of two "
                       "cameras the left and the right picture must differ");
}

}  // namespace bulletnav::bench
