// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>

#include "sim/image/codecs.h"

namespace bulletnav::sim {

int ShrinkOf(std::uint64_t width, std::uint64_t height, std::uint64_t most_pixels) {
  if (width == 0 || height == 0) throw ImageError("has no pixels");
  // A product of two such sides does not overflow.
  if (std::max(width, height) > kMostPixels || width * height > kMostPixels) {
    throw ImageError("has " + std::to_string(width) + " x " + std::to_string(height) +
                     " pixels; scale it down to 16384 x 16384 or less");
  }
  int shrink = 1;
  const auto pixels = [&] {
    return std::uint64_t(Shrunk(width, shrink)) * std::uint64_t(Shrunk(height, shrink));
  };
  while (pixels() > std::max<std::uint64_t>(1, most_pixels)) shrink *= 2;
  return shrink;
}

RowAverager::RowAverager(int width, int height, int shrink)
    : width_(width),
      height_(height),
      shrink_(shrink),
      image_(Shrunk(static_cast<std::uint64_t>(width), shrink),
             Shrunk(static_cast<std::uint64_t>(height), shrink), 4),
      sums_(4 * static_cast<std::size_t>(image_.width)) {}

void RowAverager::Add(std::span<const std::uint8_t> row) {
  if (shrink_ == 1) {
    std::copy(row.begin(), row.end(), image_.at(0, rows_++));
    return;
  }
  for (int x = 0; x < width_; ++x) {
    std::uint32_t* const sum = &sums_[4 * static_cast<std::size_t>(x / shrink_)];
    for (std::size_t c = 0; c < 4; ++c) sum[c] += row[4 * static_cast<std::size_t>(x) + c];
  }
  ++rows_;
  if (rows_ % shrink_ == 0 || rows_ == height_) FinishRow();
}

void RowAverager::FinishRow() {
  const int y = (rows_ - 1) / shrink_;
  const int rows = rows_ - y * shrink_;
  for (int x = 0; x < image_.width; ++x) {
    const int columns = std::min(shrink_, width_ - x * shrink_);
    const auto count = static_cast<std::uint32_t>(rows * columns);
    for (std::size_t c = 0; c < 4; ++c) {
      const std::uint32_t sum = sums_[4 * static_cast<std::size_t>(x) + c];
      image_.at(x, y)[c] = static_cast<std::uint8_t>((sum + count / 2) / count);
    }
  }
  std::fill(sums_.begin(), sums_.end(), 0u);
}

}  // namespace bulletnav::sim
