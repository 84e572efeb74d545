// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>

#include "benchmark/evaluate_perception/perception_cases.h"
#include "benchmark/evaluate_perception/scene_mean.h"

namespace bulletnav::bench {

/// How good the directions are that somebody would go. Where several are preferred alike, each
/// counts in part.
struct ChoiceFigures {
  MeanFigure best;       // share that is the shortest way
  MeanFigure within_1m;  // share at most 1 m longer than the shortest
  MeanFigure extra_m;    // metres longer than the shortest, ways beyond 20 m taken as 20 m

  template <class V>
  void Visit(V& v) {
    v("best", best);
    v("within_1m", within_1m);
    v("extra_m", extra_m);
  }
};

/// F_S: how soon one comes to the goal by each direction, of pairs of two nodes. A choice is a pair
/// with explorable directions whose ways differ by more than 1 m; chosen is among them.
struct ScoreFigures {
  std::int64_t pairs = 0;
  MeanFigure error;             // absolute, of all twelve directions, as the loss has it
  MeanFigure error_explorable;  // of explorable directions, the only ones that agents ask for
  MeanFigure error_of_mean;     // of those, of always saying the mean of the truth
  /// Rank correlations (Spearman) over explorable directions.
  MeanFigure rank_in_place;  // of one place, for one goal; means over choices; 0 for ties
  MeanFigure rank_for_goal;  // of all places of a scene, for one goal, as an agent compares them
  double rank_overall = 0.0;

  ChoiceFigures model;
  ChoiceFigures chance;    // any explorable direction
  ChoiceFigures reach;     // the one with the farthest floor in sight, which needs no goal
  ChoiceFigures straight;  // the one whose farthest floor is nearest to the goal in a straight
                           // line: knows where the goal is, which no model does

  template <class V>
  void Visit(V& v) {
    v("pairs", pairs);
    v("error", error);
    v("error_explorable", error_explorable);
    v("error_explorable_of_mean", error_of_mean);
    v("rank_correlation_in_place", rank_in_place);
    v("rank_correlation_for_goal", rank_for_goal);
    v("rank_correlation_overall", rank_overall);
    v("choice", model);
    v("choice_by_chance", chance);
    v("choice_by_reach", reach);
    v("choice_by_straight_line", straight);
  }
};

ScoreFigures MeasureScores(std::span<const SceneCases> scenes, std::uint64_t seed);

}  // namespace bulletnav::bench
