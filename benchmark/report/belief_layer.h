// SPDX-License-Identifier: MIT
#pragma once
#include <array>

#include "benchmark/report/canvas.h"
#include "benchmark/report/scene_map.h"
#include "benchmark/report/trajectory.h"

namespace bulletnav::bench {

/// What the agent believes: its metric map, as it lies seen from the start pose, its topological
/// graph, with scores clear of the scene's names of rooms, and where it is heading.
void DrawBelief(const SceneMap& scene, const EpisodeTrajectory& trajectory, const MapPlace& place,
                Canvas* canvas);

/// Which parts of a belief DrawBelief shows on a map: nothing that is empty or off it.
struct ShownBelief {
  std::array<bool, 4> map = {};  // by MapPicture::Kind; the unknown is never shown
  bool nodes = false;
  bool ghosts = false;
  bool scores = false;
  bool path = false;
  bool target = false;
};
ShownBelief ShownOf(const EpisodeTrajectory& trajectory, const MapPlace& place);

/// The looks of its parts, for legends.
Paint MapPaint(agent::MapPicture::Kind kind);
Stroke GraphPathStroke();

}  // namespace bulletnav::bench
