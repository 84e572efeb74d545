// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "benchmark/evaluate_perception/example_scene.h"
#include "benchmark/report/figure.h"

namespace bulletnav::bench {

// Examples of what a model says, blue, beside what is true, green. The figures they are like are
// those of Neural Topological SLAM. A figure keeps what it shows; scenes need not outlive it.

/// Like figure 3: directions that a place may be left in.
Figure ExplorableFigure(ExampleScene* scene, int place, double threshold);

/// Like figure 4: what directions of one place are worth for each of some goals, and which is best.
Figure ScoresFigure(ExampleScene* scene, int source, const std::vector<int>& goals);

/// Where a goal is said to be that is in sight of the source.
Figure RelativePoseFigure(ExampleScene* scene, int source, int goal);

/// Like figure 10: the best direction to one goal from each of some places, on their panoramas and
/// on the map.
Figure ChoicesFigure(ExampleScene* scene, const std::vector<int>& sources, int goal);

/// The directions that a model would go and that lead there soonest, among explorable ones.
struct Choice {
  int said = -1;  // -1: no direction is explorable
  int best = -1;
};
Choice ChoiceOf(const SceneCases& cases, int source, int goal);

}  // namespace bulletnav::bench
