// SPDX-License-Identifier: MIT
#pragma once
#include "benchmark/episodes/episode.h"

namespace bulletnav::bench {

/// Metres of geodesic distance; the upper end belongs to the band only if nothing follows it.
struct DistanceBand {
  double low = 0.0;
  double high = 0.0;
  bool closed = true;

  bool Holds(double distance) const {
    return distance >= low && (distance < high || (closed && distance == high));
  }
};

/// Source: Neural Topological SLAM, section 5; the last two are ours.
constexpr DistanceBand BandOf(Difficulty difficulty) {
  switch (difficulty) {
    case Difficulty::kEasy:
      return {1.5, 3.0, false};
    case Difficulty::kMedium:
      return {3.0, 5.0, false};
    case Difficulty::kHard:
      return {5.0, 10.0, true};
    case Difficulty::kVeryHard:
      return {10.0, 20.0, false};
    case Difficulty::kExtreme:
      return {20.0, 40.0, true};
  }
  return {};
}

/// From one goal to the next. Source: Neural Topological SLAM, section 6.1.
inline constexpr DistanceBand kSequentialBand = {1.5, 5.0, true};

}  // namespace bulletnav::bench
