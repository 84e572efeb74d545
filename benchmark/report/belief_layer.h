// SPDX-License-Identifier: MIT
#pragma once
#include <array>

#include "benchmark/play/trajectory.h"
#include "benchmark/report/canvas.h"
#include "benchmark/report/scene_map.h"

namespace bulletnav::bench {

/// What the agent believes, as it lies seen from the start pose: its metric map and the edges of
/// its topological graph, to be drawn under paths.
void DrawBelief(const EpisodeTrajectory& trajectory, const MapPlace& place, Canvas* canvas);
/// The nodes of its graph, with scores clear of the scene's names of rooms, and where it is
/// heading, to be drawn over paths.
void DrawBeliefMarks(const SceneMap& scene, const EpisodeTrajectory& trajectory,
                     const MapPlace& place, Canvas* canvas);

/// Which parts of a belief these show on a map: nothing that is empty or off it.
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
