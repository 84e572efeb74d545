// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <string>

#include "benchmark/report/canvas.h"
#include "benchmark/report/free_places.h"
#include "benchmark/report/goal_ends.h"

namespace bulletnav::bench {

/// Signs on maps, each centred at a point and told apart by shape, not colour alone.

/// Where an episode starts; the tip points along `heading`, radians clockwise from right.
void DrawStart(const Canvas::Point& at, double heading, Canvas* canvas);
/// A star; with a number in it for one goal of several.
void DrawGoal(const Canvas::Point& at, const std::string& number, Canvas* canvas);
/// Where the way to a goal ended. An octagon where the agent said stop: green at a goal, else
/// vermillion and crossed out; a green disc where being near was enough; a square without stop.
void DrawEnd(const Canvas::Point& at, EndKind kind, Canvas* canvas);
void DrawCollision(const Canvas::Point& at, Canvas* canvas);
/// Where the agent wanted to go.
void DrawTarget(const Canvas::Point& at, Canvas* canvas);
/// A place of a topological graph.
void DrawNode(const Canvas::Point& at, bool is_ghost, Canvas* canvas);
/// What speaks for going to ghost nodes, each beside its own, where `places` is free.
struct ScoreMark {
  Canvas::Point node;
  double score = 0.0;
};
void DrawScores(std::span<const ScoreMark> scores, FreePlaces* places, Canvas* canvas);

}  // namespace bulletnav::bench
