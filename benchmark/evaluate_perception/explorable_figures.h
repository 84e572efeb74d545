// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "benchmark/evaluate_perception/perception_cases.h"
#include "benchmark/evaluate_perception/yes_no_figures.h"

namespace bulletnav::bench {

/// F_G: directions that lead somewhere, twelve a place.
struct ExplorableFigures {
  std::int64_t directions = 0;
  double prevalence = 0.0;
  double average_precision = 0.0;
  double f1_of_yes = 0.0;  // of always saying yes
  YesNoFigures at;         // the config's threshold
  std::vector<YesNoFigures> thresholds;

  template <class V>
  void Visit(V& v) {
    v("directions", directions);
    v("prevalence", prevalence);
    v("average_precision", average_precision);
    v("f1_of_always_yes", f1_of_yes);
    v("at_threshold", at);
    v("thresholds", thresholds);
  }
};

ExplorableFigures MeasureExplorable(std::span<const SceneCases> scenes, double threshold);

}  // namespace bulletnav::bench
