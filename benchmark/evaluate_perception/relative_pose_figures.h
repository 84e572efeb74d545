// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "benchmark/evaluate_perception/perception_cases.h"
#include "benchmark/evaluate_perception/scene_mean.h"

namespace bulletnav::bench {

/// F_R: where the goal is, of all pairs of one node whatever F_L says of them.
struct RelativePoseFigures {
  /// What is measured of all such pairs, and of those of a bin of distance.
  struct Means {
    MeanFigure direction_exact;  // share whose likeliest direction is right; of guessing: 1/12
    MeanFigure direction_near;   // right or a neighbour; 3/12
    MeanFigure bearing_error;    // degrees, absolute, of agent::RelativePoseOf
    MeanFigure distance_error;   // metres, absolute
    MeanFigure place_error;      // metres between the goal and where it is said to be

    template <class V>
    void Visit(V& v) {
      v("direction_exact", direction_exact);
      v("direction_within_one", direction_near);
      v("bearing_error_deg", bearing_error);
      v("distance_error_m", distance_error);
      v("place_error_m", place_error);
    }
  };
  struct Bin {
    std::string bin;  // metres
    Means means;

    template <class V>
    void Visit(V& v) {
      v("bin", bin);
      means.Visit(v);
    }
  };
  Means all;
  double distance_error_of_median = 0.0;  // metres, of always saying the median of the truth
  std::vector<Bin> by_distance;           // up to 3 m

  template <class V>
  void Visit(V& v) {
    all.Visit(v);
    v("distance_error_of_median_m", distance_error_of_median);
    v("by_distance", by_distance);
  }
};

RelativePoseFigures MeasureRelativePoses(std::span<const SceneCases> scenes, std::uint64_t seed);

}  // namespace bulletnav::bench
