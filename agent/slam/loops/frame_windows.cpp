// SPDX-License-Identifier: MIT
#include "agent/slam/loops/frame_windows.h"

#include <algorithm>
#include <cstddef>

#include "sim/base/check.h"

namespace bulletnav::agent {
namespace {

/// Each value becomes the largest among its row's within `radius` columns; then the matrix is
/// turned over.
std::vector<float> WidenedAndTurned(const std::vector<float>& values, std::size_t count,
                                    std::size_t radius) {
  std::vector<float> turned(values.size());
  for (std::size_t row = 0; row < count; ++row) {
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(row * count);
    for (std::size_t column = 0; column < count; ++column) {
      const std::size_t first = column - std::min(column, radius);
      const std::size_t end = std::min(column + radius + 1, count);
      turned[column * count + row] = *std::max_element(at + static_cast<std::ptrdiff_t>(first),
                                                       at + static_cast<std::ptrdiff_t>(end));
    }
  }
  return turned;
}

}  // namespace

FrameWindows::FrameWindows(const DescriptorFrames& frames, int radius)
    : count_(static_cast<std::size_t>(frames.size())), best_(count_ * count_) {
  BULLETNAV_CHECK(radius >= 0);
  for (int later = 0; later < frames.size(); ++later) {
    for (int earlier = 0; earlier <= later; ++earlier) {
      const auto a = static_cast<std::size_t>(later);
      const auto b = static_cast<std::size_t>(earlier);
      const auto cosine =
          static_cast<float>(Cosine(frames.descriptor(later), frames.descriptor(earlier)));
      best_[a * count_ + b] = cosine;
      best_[b * count_ + a] = cosine;
    }
  }
  const auto reach = static_cast<std::size_t>(radius);
  best_ = WidenedAndTurned(WidenedAndTurned(best_, count_, reach), count_, reach);
}

}  // namespace bulletnav::agent
