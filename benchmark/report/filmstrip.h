// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "benchmark/play/trajectory.h"
#include "benchmark/report/figure.h"
#include "benchmark/report/scene_map.h"
#include "sim/world.h"

namespace bulletnav::bench {

struct FilmstripSpec {
  int frames = 7;  // the first and the last included; fewer if there are fewer steps
  sim::PanoramaSpec panorama{.rows = 192, .cols = 768};
  int columns = 2;             // of panoramas
  double frame_width = 384.0;  // units of the canvas
  double map_width = 600.0;    // at most
  bool belief = false;         // draw on the map what the agent believes, where it says so
  std::string title = {};      // of the agent, for people; empty: its name
};

/// The numbers of steps whose panoramas are shown: evenly spread from 0 to the last.
std::vector<int> FilmSteps(std::size_t steps, int frames);

/// The number, from 0, of the goal that the agent was looking for after so many actions; after the
/// last one, of that it had been looking for.
std::size_t GoalAt(const EpisodeTrajectory& trajectory, std::size_t actions);

/// What the body saw along an episode, each time below what it was then looking for if that is new,
/// and beside it the map with the places numbered. Throws sim::Error if the episode cannot be
/// replayed (see replay.h).
Figure Filmstrip(const std::shared_ptr<const sim::World>& world, const SceneMap& map,
                 const EpisodeTrajectory& trajectory, const FilmstripSpec& spec = {});

}  // namespace bulletnav::bench
