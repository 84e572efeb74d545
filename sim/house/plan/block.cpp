// SPDX-License-Identifier: MIT
#include "sim/house/plan/block.h"

#include <algorithm>
#include <cmath>

namespace bulletnav::sim::plan {
namespace {

double TargetSum(const Draft& draft, const std::vector<int>& rooms) {
  double sum = 0.0;
  for (const int room : rooms)
    sum += static_cast<double>(draft.rooms[static_cast<std::size_t>(room)].target);
  return sum;
}

void Add(int room, const Box& box, Draft* draft) {
  draft->rooms[static_cast<std::size_t>(room)].boxes.push_back(box);
}

/// The living room around a corner room.
void SliceCorner(const Box& box, int living, int corner, Draft* draft, Rng* rng) {
  const double share = TargetSum(*draft, {corner}) / TargetSum(*draft, {living, corner});
  const double part = std::clamp(std::sqrt(share) * rng->Uniform(0.85, 1.2), 0.35, 0.7);
  const int width = SnapToGrid(part * box.width());
  const int height = SnapToGrid(std::min(0.75, share / part) * box.height());
  const bool right = rng->Chance(0.5);
  const bool low = rng->Chance(0.5);
  const int cut_x = right ? box.x1 - width : box.x0 + width;
  const int cut_y = low ? box.y1 - height : box.y0 + height;
  const int y0 = low ? cut_y : box.y0;
  const int y1 = low ? box.y1 : cut_y;
  Add(corner, {right ? cut_x : box.x0, y0, right ? box.x1 : cut_x, y1}, draft);
  Add(living, {right ? box.x0 : cut_x, y0, right ? cut_x : box.x1, y1}, draft);
  Add(living, {box.x0, low ? box.y0 : cut_y, box.x1, low ? cut_y : box.y1}, draft);
}

}  // namespace

void SliceBlock(const Box& box, std::vector<int> rooms, Draft* draft, Rng* rng) {
  if (rooms.size() == 1) {
    Add(rooms[0], box, draft);
    return;
  }
  rng->Shuffle(rooms);
  if (rooms.size() == 2 && rng->Chance(0.3)) {
    if (draft->type(rooms[1]) == RoomType::kLivingRoom) std::swap(rooms[0], rooms[1]);
    if (draft->type(rooms[0]) == RoomType::kLivingRoom) {
      SliceCorner(box, rooms[0], rooms[1], draft, rng);
      return;
    }
  }
  const int first_count = rng->Between(1, static_cast<int>(rooms.size()) - 1);
  const std::vector<int> first(rooms.begin(), rooms.begin() + first_count);
  const std::vector<int> rest(rooms.begin() + first_count, rooms.end());
  const double share = TargetSum(*draft, first) / TargetSum(*draft, rooms);
  Box a = box;
  Box b = box;
  if (rng->Chance(box.width() > box.height() ? 0.7 : 0.3)) {
    a.x1 = b.x0 = box.x0 + SnapToGrid(share * box.width());
  } else {
    a.y1 = b.y0 = box.y0 + SnapToGrid(share * box.height());
  }
  SliceBlock(a, first, draft, rng);
  SliceBlock(b, rest, draft, rng);
}

}  // namespace bulletnav::sim::plan
