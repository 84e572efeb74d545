// SPDX-License-Identifier: MIT
#include "agent/slam/descriptors/code_descriptor.h"

#include <cmath>
#include <cstddef>
#include <vector>

#include "agent/integer/integer_encoder.h"
#include "sim/base/check.h"

namespace bulletnav::agent {
namespace {

constexpr int kFine = 1 << 8;  // steps of a root a step of a code
constexpr std::size_t kMostPatches = 1024;

}  // namespace

PictureDescriptor DescribeCodes(std::span<const std::int16_t> codes, int size) {
  const auto width = static_cast<std::size_t>(size);
  BULLETNAV_CHECK(size > 0 && !codes.empty() && codes.size() % width == 0);
  const std::size_t patches = codes.size() / width;
  BULLETNAV_CHECK_LE(patches, kMostPatches);
  std::vector<std::int64_t> cubes(width, 0);
  for (std::size_t i = 0; i < codes.size(); ++i) {
    BULLETNAV_CHECK(codes[i] >= 0 && codes[i] <= kLargest16);
    cubes[i % width] += std::int64_t{codes[i]} * codes[i] * codes[i];
  }
  for (std::int64_t& cube : cubes) {
    // The sum fits into 46 bits and is exact; std::cbrt has one version only.
    const double root = std::cbrt(static_cast<double>(cube) / static_cast<double>(patches));
    cube = std::llround(kFine * root);
  }
  return DirectionOf(cubes);
}

}  // namespace bulletnav::agent
