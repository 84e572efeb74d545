// SPDX-License-Identifier: MIT
#pragma once
#include "sim/sensors/noise/kernels/noise_kernels.h"
#include "sim/sensors/noise/kernels/pixel_random.h"

namespace bulletnav::sim {
namespace {

/// Noise of a colour picture, row by row.
class ColorRows {
 public:
  explicit ColorRows(const ColorNoiseFrame& frame) : frame_(frame), values_(3 * frame.cols) {
    for (int i = 0; i < kLanes; ++i) {
      balance_[i] = 255.0f * frame.balance[i % 3];
    }
  }

  void Run() const {
    for (int row = 0; row < frame_.rows; ++row) {
      MixRows(row);
      MixColumns(row);
    }
  }

 private:
  static constexpr int kLanes = 48;  // whole pixels and whole vectors
  static constexpr float kFull = 65536.0f * 255.0f;

  const std::uint8_t* In(int row) const {
    const int last = frame_.rows - 1;
    const int inside = row < 0 ? 0 : (row > last ? last : row);
    return frame_.in + static_cast<std::int64_t>(inside) * values_;
  }

  /// Blurs upwards into `line`, a neighbour on either side.
  void MixRows(int row) const {
    const std::uint8_t* above = In(row - 1);
    const std::uint8_t* here = In(row);
    const std::uint8_t* below = In(row + 1);
    std::uint16_t* line = frame_.line + 3;
    const std::uint32_t blur = frame_.blur;
    for (int i = 0; i < values_; ++i) {
      line[i] = static_cast<std::uint16_t>((256u - 2u * blur) * here[i] +
                                           blur * (std::uint32_t{above[i]} + below[i]));
    }
    for (int i = 0; i < 3; ++i) {
      line[i - 3] = line[frame_.wraps ? values_ - 3 + i : i];
      line[values_ + i] = line[frame_.wraps ? i : values_ - 3 + i];
    }
  }

  /// Blurs across, and what comes after blur. Places of the last block overlap those before, so
  /// that all blocks are whole: they come out the same twice.
  void MixColumns(int row) const {
    for (int i = 0; i < values_; i += kLanes) {
      Block(row, i + kLanes <= values_ ? i : values_ - kLanes);
    }
  }

  void Block(int row, int first) const {
    const std::uint16_t* line = frame_.line + 3 + first;
    const auto place = static_cast<std::uint32_t>(row * values_ + first);
    std::uint8_t* out = frame_.out + place;
    const std::uint32_t blur = frame_.blur;
    const float gain = frame_.exposure / kFull;
    for (int i = 0; i < kLanes; ++i) {
      const std::uint32_t mixed =
          (256u - 2u * blur) * line[i] + blur * (std::uint32_t{line[i - 3]} + line[i + 3]);
      const float seen = gain * static_cast<float>(static_cast<std::int32_t>(mixed));
      const float light = seen * seen;
      const float normal =
          PixelNormal(PixelBits(place + static_cast<std::uint32_t>(i), frame_.key));
      const float sigma = __builtin_sqrtf(light * frame_.shot + frame_.read_squared);
      const float read = PixelMin(1.0f, PixelMax(0.0f, light + sigma * normal));
      const float shown = PixelMin(255.0f, __builtin_sqrtf(read) * balance_[i]);
      out[i] = static_cast<std::uint8_t>(PixelRound(shown));
    }
  }

  const ColorNoiseFrame& frame_;
  int values_;
  float balance_[kLanes] = {};
};

}  // namespace
}  // namespace bulletnav::sim
