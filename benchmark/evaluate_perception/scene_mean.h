// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <limits>
#include <vector>

#include "benchmark/base/statistics.h"

namespace bulletnav::bench {

/// A mean over cases with its 95% confidence: [-inf, inf] where one scene is all there is.
struct MeanFigure {
  std::int64_t count = 0;
  double value = std::numeric_limits<double>::quiet_NaN();  // of no cases: not a number
  Interval interval;

  template <class V>
  void Visit(V& v) {
    v("count", count);
    v("value", value);
    v("low", interval.low);
    v("high", interval.high);
  }
};

/// Sums values scene by scene: cases of one scene are alike, so that confidence comes from drawing
/// whole scenes again. Source: the cluster bootstrap, Davison and Hinkley, 1997, section 3.8.
class SceneMean {
 public:
  /// The values that follow are of another scene.
  void NextScene() { scenes_.emplace_back(); }
  /// Expects: NextScene was called.
  void Add(double value);
  /// 1000 draws; the same for the same values and seed.
  MeanFigure Figure(std::uint64_t seed) const;

 private:
  struct Sum {
    double sum = 0.0;
    std::int64_t count = 0;
  };
  std::vector<Sum> scenes_;
};

}  // namespace bulletnav::bench
