// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "benchmark/play/trajectory.h"
#include "benchmark/report/scene_map.h"
#include "benchmark/report/webp.h"
#include "sim/world.h"

namespace bulletnav::bench {

struct AnimationSpec {
  int frames = 72;  // at most: the start, the end, and steps evenly between
  int frame_ms = 120;
  int last_ms = 3000;  // before it begins anew
  sim::PanoramaSpec panorama{.rows = 128, .cols = 512};
  double panorama_width = 440.0;  // units of the canvas
  double map_width = 400.0;       // at most
  double map_height = 330.0;      // at most
  double scale = 1.0;             // pixels a unit
  std::string title = {};         // of the agent, for people; empty: its name
  /// What the agent believed before action i, if that is known; nothing is drawn of it if empty.
  std::function<agent::Belief(std::size_t action)> belief = {};
};

/// An episode as a moving picture: the goal's panorama, what the body sees, and the map of the
/// scene with the way until then and what the agent believed. Throws sim::Error if the episode
/// cannot be replayed (see replay.h).
std::vector<AnimationFrame> EpisodeAnimation(const std::shared_ptr<const sim::World>& world,
                                             const SceneMap& map,
                                             const EpisodeTrajectory& trajectory,
                                             const AnimationSpec& spec = {});

}  // namespace bulletnav::bench
