// SPDX-License-Identifier: MIT
#include "agent/slam/retrieval/picture_descriptor.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "sim/base/check.h"

namespace bulletnav::agent {

PictureDescriptor DirectionOf(std::span<const std::int64_t> numbers) {
  BULLETNAV_CHECK_LE(numbers.size(), std::size_t{1024});
  std::int64_t largest = 0;
  for (const std::int64_t number : numbers) largest = std::max(largest, std::abs(number));
  // Squares of so many numbers below 2^26 add up within 63 bits.
  int shift = 0;
  while ((largest >> shift) >= (std::int64_t{1} << 26)) ++shift;
  std::int64_t squares = 0;
  for (const std::int64_t number : numbers) {
    const std::int64_t small = number / (std::int64_t{1} << shift);
    squares += small * small;
  }
  PictureDescriptor direction(numbers.size(), 0);
  if (squares == 0) return direction;
  // A root and a division in double precision are rounded in one way only.
  const double factor = kDescriptorUnit / (std::sqrt(static_cast<double>(squares)) *
                                           static_cast<double>(std::int64_t{1} << shift));
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    direction[i] =
        static_cast<std::int16_t>(std::nearbyint(static_cast<double>(numbers[i]) * factor));
  }
  return direction;
}

PictureDescriptor MeanDirection(std::span<const PictureDescriptor> descriptors) {
  BULLETNAV_CHECK(!descriptors.empty());
  std::vector<std::int64_t> sum(descriptors.front().size(), 0);
  for (const PictureDescriptor& descriptor : descriptors) {
    BULLETNAV_CHECK_EQ(descriptor.size(), sum.size());
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += descriptor[i];
  }
  return DirectionOf(sum);
}

}  // namespace bulletnav::agent
