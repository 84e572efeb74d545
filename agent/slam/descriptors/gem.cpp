// SPDX-License-Identifier: MIT
#include "agent/slam/descriptors/gem.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "agent/slam/descriptors/descriptor_config.h"
#include "sim/base/check.h"
#include "sim/base/elementary.h"
#include "sim/base/error.h"

namespace bulletnav::agent {
namespace {

constexpr double kOne = 1LL << 48;  // of a power; up to 2^14 places add up within 63 bits
constexpr std::size_t kMostPlaces = 1 << 14;

}  // namespace

Gem::Gem(double exponent) : exponent_(exponent), powers_{} {
  if (!(exponent >= kLeastExponent && exponent <= kMostExponent)) {
    throw sim::Error("GeM's exponent must lie between 1 and 8");
  }
  for (std::size_t i = 0; i < powers_.size(); ++i) {
    powers_[i] = std::llround(kOne * sim::Pow(static_cast<double>(i) / 255.0, exponent));
  }
}

std::vector<std::int16_t> Gem::Pool(std::span<const std::uint8_t* const> places,
                                    int channels) const {
  BULLETNAV_CHECK(!places.empty() && places.size() <= kMostPlaces);
  std::vector<std::int64_t> sums(static_cast<std::size_t>(channels), 0);
  for (const std::uint8_t* place : places) {
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += powers_[place[i]];
  }
  std::vector<std::int16_t> pooled;
  pooled.reserve(sums.size());
  const double all = kOne * static_cast<double>(places.size());
  for (const std::int64_t sum : sums) {
    const double mean = sim::Pow(static_cast<double>(sum) / all, 1.0 / exponent_);
    const auto steps = static_cast<int>(std::nearbyint(mean * kLargest));
    pooled.push_back(static_cast<std::int16_t>(std::clamp(steps, 0, kLargest)));
  }
  return pooled;
}

}  // namespace bulletnav::agent
