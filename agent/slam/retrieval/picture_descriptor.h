// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace bulletnav::agent {

/// What a picture, or several in a row, looks like as a whole: a direction in whole numbers, about
/// kDescriptorUnit long. Whole numbers add up to the same in any order and on any processor.
using PictureDescriptor = std::vector<std::int16_t>;

inline constexpr int kDescriptorUnit = 1 << 14;

/// Cosine of the angle between two descriptors of one size, but for rounding. Expects: at most 1024
/// numbers, each within kDescriptorUnit (checked by those who make them).
inline double Cosine(std::span<const std::int16_t> a, std::span<const std::int16_t> b) {
  // Within 32 bits: no part of the sum is longer than the product of both lengths.
  std::int32_t sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += std::int32_t{a[i]} * b[i];
  return static_cast<double>(sum) / (static_cast<double>(kDescriptorUnit) * kDescriptorUnit);
}

/// The direction of some numbers, sums of descriptors say; all zeros have none and stay so.
/// Expects: at most 1024 numbers (checked).
PictureDescriptor DirectionOf(std::span<const std::int64_t> numbers);

/// The direction of the mean of descriptors. Expects: at least one, all of one size (checked).
PictureDescriptor MeanDirection(std::span<const PictureDescriptor> descriptors);

}  // namespace bulletnav::agent
