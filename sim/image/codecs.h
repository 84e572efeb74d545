// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>

#include "sim/image/image.h"

namespace bulletnav::sim {

/// 16,384 x 16,384.
inline constexpr std::uint64_t kMostPixels = std::uint64_t{1} << 28;

/// One decoder a format, all to RGBA, halved as DecodeImage says; they throw ImageError.
Image DecodePng(std::span<const std::uint8_t> bytes, std::uint64_t most_pixels);
Image DecodeJpeg(std::span<const std::uint8_t> bytes, std::uint64_t most_pixels);
Image DecodeWebp(std::span<const std::uint8_t> bytes, std::uint64_t most_pixels);
/// BMP and TGA.
Image DecodeWithStb(std::span<const std::uint8_t> bytes, std::uint64_t most_pixels);

/// Side of the squares of pixels that become one: 1, 2, 4...
/// Throws ImageError for pictures without pixels or with more than kMostPixels.
int ShrinkOf(std::uint64_t width, std::uint64_t height, std::uint64_t most_pixels);

/// `size` pixels in squares of side `shrink`, the last of which may be cut.
constexpr int Shrunk(std::uint64_t size, int shrink) {
  const auto side = static_cast<std::uint64_t>(shrink);
  return static_cast<int>((size + side - 1) / side);
}

/// Means over squares of pixels, from RGBA rows that come one after the other.
class RowAverager {
 public:
  RowAverager(int width, int height, int shrink);
  /// One more row of `width` pixels.
  void Add(std::span<const std::uint8_t> row);
  /// After the last row.
  Image Take() { return std::move(image_); }

 private:
  void FinishRow();

  int width_;
  int height_;
  int shrink_;
  int rows_ = 0;  // that have been added
  Image image_;
  std::vector<std::uint32_t> sums_;
};

}  // namespace bulletnav::sim
