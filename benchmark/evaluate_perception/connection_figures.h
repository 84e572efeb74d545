// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "benchmark/evaluate_perception/perception_cases.h"
#include "benchmark/evaluate_perception/scene_mean.h"
#include "benchmark/evaluate_perception/yes_no_figures.h"

namespace bulletnav::bench {

/// Upper ends, in metres, of the bins of distance between two places, the last but one that of
/// "5-10 m".
inline constexpr std::array kDistanceBins = {
    0.5, 1.0, 2.0, 3.0, 5.0, 10.0, std::numeric_limits<double>::infinity()};
std::size_t DistanceBin(double metres);
/// "0-0.5", ..., "10+".
std::string DistanceBinName(std::size_t bin);

/// Pairs that have something in common.
struct ConnectionBin {
  std::string bin;                 // "0-0.5" to "10+" m, or "0" to "3+" walls
  MeanFigure accuracy;             // share of right answers
  MeanFigure recall;               // of pairs of one node
  MeanFigure false_positive_rate;  // of pairs of two

  template <class V>
  void Visit(V& v) {
    v("bin", bin);
    v("accuracy", accuracy);
    v("recall", recall);
    v("false_positive_rate", false_positive_rate);
  }
};

/// F_L: whether the goal belongs to the source's node. Over all ordered pairs of different places
/// of a scene, so that pairs of one node are as rare as they are.
struct ConnectionFigures {
  std::int64_t pairs = 0;
  double prevalence = 0.0;  // share of one node: the average precision of guessing
  double average_precision = 0.0;
  YesNoFigures at;                           // the config's threshold
  std::vector<ConnectionBin> by_distance;    // straight, level
  std::vector<ConnectionBin> by_walls;       // that a straight line crosses
  std::vector<ConnectionBin> by_walls_near;  // of pairs within 3 m
  std::vector<YesNoFigures> thresholds;
  std::vector<PrecisionRecall> curve;  // at every percent of recall

  template <class V>
  void Visit(V& v) {
    v("pairs", pairs);
    v("prevalence", prevalence);
    v("average_precision", average_precision);
    v("at_threshold", at);
    v("by_distance", by_distance);
    v("by_walls", by_walls);
    v("by_walls_within_3m", by_walls_near);
    v("thresholds", thresholds);
    v("curve", curve);
  }
};

ConnectionFigures MeasureConnection(std::span<const SceneCases> scenes, double threshold,
                                    std::uint64_t seed);

}  // namespace bulletnav::bench
