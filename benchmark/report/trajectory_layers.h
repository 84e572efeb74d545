// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "benchmark/play/trajectory.h"
#include "benchmark/report/canvas.h"
#include "benchmark/report/scene_map.h"

namespace bulletnav::bench {

/// Where the body stood at the start and after each step: one more than there are steps.
std::vector<sim::BodyPose> TruePoses(const EpisodeTrajectory& trajectory);

/// The layers of a trajectory, to be drawn on a scene's map from first to last.

void DrawShortestPath(const EpisodeTrajectory& trajectory, const MapPlace& place, Canvas* canvas);
/// The true way until a step, coloured by the share of all steps that is over.
void DrawTruePath(const EpisodeTrajectory& trajectory, std::size_t until, const MapPlace& place,
                  Canvas* canvas);
void DrawOdometry(const EpisodeTrajectory& trajectory, const MapPlace& place, Canvas* canvas);
/// Where crosses stand for collisions, on the canvas: one for all that are near each other, so that
/// the path between them is seen.
std::vector<Canvas::Point> CollisionMarks(const EpisodeTrajectory& trajectory,
                                          const MapPlace& place);
/// Collisions, goals, start, ends.
void DrawMarks(const EpisodeTrajectory& trajectory, const MapPlace& place, Canvas* canvas);

/// The lines' looks, for legends.
Stroke OdometryStroke();
Stroke ShortestPathStroke();

}  // namespace bulletnav::bench
