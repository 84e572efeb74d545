// SPDX-License-Identifier: MIT
#include "agent/slam/retrieval/picture_descriptor.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "sim/base/check.h"

namespace bulletnav::agent {

PictureDescriptor DirectionOf(std::span<const std::int64_t> numbers) {
  std::int64_t largest = 0;
  for (const std::int64_t number : numbers) largest = std::max(largest, std::abs(number));
  // Squares of up to 1024 numbers below 2^26 stay below 2^62.
  BULLETNAV_CHECK(largest < (std::int64_t{1} << 26) && numbers.size() <= 1024);
  std::int64_t squares = 0;
  for (const std::int64_t number : numbers) squares += number * number;
  PictureDescriptor direction(numbers.size(), 0);
  if (squares == 0) return direction;
  // A root and a division in double precision are rounded in one way only.
  const double factor = kDescriptorUnit / std::sqrt(static_cast<double>(squares));
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
  // So many frames that the sum would grow too large are never of one sequence; halving keeps it.
  while (std::any_of(sum.begin(), sum.end(), [](std::int64_t number) {
    return std::abs(number) >= (std::int64_t{1} << 26);
  })) {
    for (std::int64_t& number : sum) number /= 2;
  }
  return DirectionOf(sum);
}

}  // namespace bulletnav::agent
