// SPDX-License-Identifier: MIT
#include "sim/scene/patches.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "sim/base/check.h"

namespace bulletnav::sim {

float ThresholdOf(std::span<const float> values, std::span<const double> weights, double share) {
  BULLETNAV_CHECK(values.size() == weights.size());
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return values[a] != values[b] ? values[a] > values[b] : a < b;
  });
  double left = share * std::accumulate(weights.begin(), weights.end(), 0.0);
  for (const std::size_t i : order) {
    left -= 0.5 * weights[i];
    if (left <= 0.0) return values[i];
    left -= 0.5 * weights[i];
  }
  return share > 0.0 && !order.empty() ? values[order.back()] - 1.0f
                                       : std::numeric_limits<float>::infinity();
}

}  // namespace bulletnav::sim
