// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "benchmark/play/trajectory.h"
#include "benchmark/report/figure.h"
#include "benchmark/report/scene_map.h"

namespace bulletnav::bench {

struct TrajectoryPlotSpec {
  double map_width = 820.0;   // at most, units of the canvas
  double map_height = 620.0;  // at most
  bool belief = false;        // draw what the agent believes, where it says so
  std::string title = {};     // of the agent, for people; empty: its name
};

/// An episode on the map of its scene: the true path coloured by time with a bar that tells the
/// steps, the path that odometry believed, the shortest path, start, goals, collisions, stops, and
/// beside it a legend and how the episode went. The figure keeps copies of what it is given.
Figure TrajectoryPlot(const SceneMap& map, const EpisodeTrajectory& trajectory,
                      const TrajectoryPlotSpec& spec = {});

/// How an episode went, in a few short lines.
std::vector<std::string> OutcomeLines(const EpisodeTrajectory& trajectory);

}  // namespace bulletnav::bench
