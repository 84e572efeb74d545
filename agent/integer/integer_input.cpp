// SPDX-License-Identifier: MIT
#include "agent/integer/integer_input.h"

#include <array>
#include <bit>
#include <limits>

#include "agent/integer/integer_trunk.h"
#include "sim/base/check.h"

namespace bulletnav::agent {
namespace {

constexpr int kMostCols = 4 * kInputRows;
constexpr int kLargest = 2 * kInputZero;
constexpr int kStepsPerMetre = 256;
constexpr float kFarthest = 10.0f;  // metres

/// Entry i is i / (count - 1) of kLargest.
std::vector<std::uint8_t> Shares(int count) {
  std::vector<std::uint8_t> shares(static_cast<std::size_t>(count));
  const int last = count - 1;
  for (int i = 0; i < count; ++i) {
    shares[static_cast<std::size_t>(i)] =
        static_cast<std::uint8_t>((2 * kLargest * i + last) / (2 * last));
  }
  return shares;
}

/// What is no number is nothing. By bits, of which those of positive numbers are in order:
/// compilers make vectors of that.
int DepthSteps(float metres) {
  constexpr auto kInfinity = std::bit_cast<std::int32_t>(std::numeric_limits<float>::infinity());
  constexpr auto kMost = std::bit_cast<std::int32_t>(kFarthest);
  std::int32_t bits = std::bit_cast<std::int32_t>(metres);
  bits = bits > kInfinity ? 0 : bits;
  bits = bits < 0 ? 0 : bits;
  bits = bits > kMost ? kMost : bits;
  return static_cast<int>(std::bit_cast<float>(bits) * kStepsPerMetre);
}

/// Sums over squares of kFactor pixels of the kFactor rows of `cols` pixels from `in` on.
template <int kFactor>
void SumColors(const std::uint8_t* in, int cols, const std::uint8_t* of_sum, std::uint8_t* out) {
  for (int col = 0; col < cols / kFactor; ++col) {
    std::array<int, 3> sum{};
    for (int y = 0; y < kFactor; ++y) {
      const std::uint8_t* pixel = in + 3 * (y * cols + col * kFactor);
      for (int x = 0; x < kFactor; ++x, pixel += 3) {
        for (std::size_t c = 0; c < 3; ++c) sum[c] += pixel[c];
      }
    }
    for (std::size_t c = 0; c < 3; ++c) {
      out[col * kInputChannels + static_cast<int>(c)] = of_sum[sum[c]];
    }
  }
}

template <int kFactor>
void SumDepths(const float* in, int cols, const std::uint8_t* of_sum, std::uint8_t* out) {
  std::array<int, kMostCols> sums{};
  const auto size = static_cast<std::size_t>(cols);
  for (int y = 0; y < kFactor; ++y) {
    for (std::size_t col = 0; col < size; ++col) {
      sums[col] += DepthSteps(in[static_cast<std::size_t>(y) * size + col]);
    }
  }
  for (int col = 0; col < cols / kFactor; ++col) {
    int sum = 0;
    for (int x = 0; x < kFactor; ++x) sum += sums[static_cast<std::size_t>(col * kFactor + x)];
    out[col * kInputChannels + 3] = of_sum[sum];
  }
}

}  // namespace

IntegerInput::IntegerInput(int rows, bool uses_depth, int panorama_rows)
    : rows_(panorama_rows),
      factor_(panorama_rows / rows),
      uses_depth_(uses_depth),
      color_of_sum_(Shares(255 * factor_ * factor_ + 1)),
      depth_of_sum_(Shares(static_cast<int>(kFarthest) * kStepsPerMetre * factor_ * factor_ + 1)) {
  BULLETNAV_CHECK(factor_ == 1 || factor_ == 2 || factor_ == 4);
  BULLETNAV_CHECK(panorama_rows <= kInputRows && factor_ * rows == panorama_rows);
}

void IntegerInput::Prepare(const Panorama& panorama, int index, Pictures* pictures) const {
  const int cols = 4 * rows_;
  const std::size_t pixels = static_cast<std::size_t>(rows_) * static_cast<std::size_t>(cols);
  BULLETNAV_CHECK_EQ(panorama.color.size(), 3 * pixels);
  if (uses_depth_) BULLETNAV_CHECK_EQ(panorama.depth.size(), pixels);
  const PictureShape& shape = pictures->shape;
  BULLETNAV_CHECK_EQ(shape.rows * factor_, rows_);
  for (int row = 0; row < shape.rows; ++row) {
    std::uint8_t* out =
        pictures->bytes.data() + std::ptrdiff_t{index} * shape.size() + shape.Offset(row, 0);
    const std::ptrdiff_t first = std::ptrdiff_t{row} * factor_ * cols;
    const auto sum_colors = factor_ == 1   ? SumColors<1>
                            : factor_ == 2 ? SumColors<2>
                                           : SumColors<4>;
    sum_colors(panorama.color.data() + 3 * first, cols, color_of_sum_.data(), out);
    if (!uses_depth_) continue;
    const auto sum_depths = factor_ == 1   ? SumDepths<1>
                            : factor_ == 2 ? SumDepths<2>
                                           : SumDepths<4>;
    sum_depths(panorama.depth.data() + first, cols, depth_of_sum_.data(), out);
  }
}

}  // namespace bulletnav::agent
