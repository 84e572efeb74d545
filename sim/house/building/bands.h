// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "sim/house/plan/draft.h"
#include "sim/house/plan/links.h"
#include "sim/house/plan/strip.h"
#include "sim/math/rng.h"

namespace bulletnav::sim::building {

/// A small room cut from another one's corner at the corridor: the bath of a hotel room. Metres.
struct Alcove {
  RoomType type = RoomType::kBathroom;
  float width = 0.0f;  // 0: none
  float depth = 0.0f;
};

/// What a row may hold. Lengths in metres, clear.
struct Cell {
  RoomType type = RoomType::kOffice;
  float min_width = 3.0f;  // along the row
  float max_width = 5.0f;
  double weight = 1.0;  // how readily it is taken; 0: no more than `least`
  int least = 0;
  int most = 99;
  OpeningKind way = OpeningKind::kDoor;  // how it is entered
  bool is_crossing = false;              // joins the halls on both sides of its row
  Alcove alcove = {};
};

/// One of the parallel stripes that a building is made of: a hall (a corridor, or a large room), or
/// a row of cells.
struct Band {
  float depth = 4.0f;  // clear
  std::optional<RoomType> hall = {};
  std::span<const Cell> cells = {};
  float share = 1.0f;  // of the length that a row takes; beyond it is outside
};

/// A room at the end of the stripes, across all of them.
struct End {
  RoomType type = RoomType::kLobby;
  float length = 6.0f;  // clear
  OpeningKind way = OpeningKind::kArch;
};

/// Stripes beside each other, all of one length.
struct Block {
  std::vector<Band> bands;
  float length = 20.0f;     // clear, without the ends
  std::optional<End> head;  // before the beginning
  std::optional<End> tail;  // beyond the end
};

/// A building's rooms and who is joined to whom, before there are walls.
struct Sketch {
  plan::Draft draft;
  std::vector<plan::Link> links;

  int Add(RoomType type, const plan::Box& box);
  void Join(int a, int b, OpeningKind way);
};

/// What has become of a block: indices of rooms.
struct LaidBlock {
  std::vector<int> halls;
  int head = -1;
  int tail = -1;
};

/// From the first stripe's outer edge to the last one's, centimetres between middle lines.
int GrossDepth(const plan::Draft& draft, const Block& block);

/// Lays a block out: rows are filled with their cells in random order and widths, each joined to a
/// hall beside it, ends to every hall. Stripes run along `axes.along` from its origin and lie
/// beside each other along `axes.out`. With `head` >= 0 that room, which is there already, is the
/// head.
LaidBlock LayBlock(const Block& block, const plan::Axes& axes, int head, Sketch* sketch, Rng* rng);

/// Lays a block out straight, or, where it is longer than `longest` metres, bent by a right angle:
/// half of it on either side of its head, which fills the corner.
void LayBent(Block block, float longest, Sketch* sketch, Rng* rng);

}  // namespace bulletnav::sim::building
