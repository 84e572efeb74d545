// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <string>

#include "benchmark/report/figure.h"
#include "benchmark/report/scene_map.h"
#include "benchmark/report/trajectory.h"
#include "sim/world.h"

namespace bulletnav::bench {

struct FilmstripSpec {
  int frames = 7;  // the first and the last included; fewer if there are fewer steps
  sim::PanoramaSpec panorama{.rows = 192, .cols = 768};
  int columns = 2;             // of panoramas
  double frame_width = 384.0;  // units of the canvas
  double map_width = 600.0;    // at most
  std::string title = {};      // of the agent, for people; empty: its name
};

/// The numbers of steps whose panoramas are shown: evenly spread from 0 to the last.
std::vector<int> FilmSteps(std::size_t steps, int frames);

/// What the body saw along an episode, below what it was looking for, and beside it the map with
/// the places numbered. Throws sim::Error if the episode cannot be replayed (see replay.h).
Figure Filmstrip(const std::shared_ptr<const sim::World>& world, const SceneMap& map,
                 const EpisodeTrajectory& trajectory, const FilmstripSpec& spec = {});

}  // namespace bulletnav::bench
