// SPDX-License-Identifier: MIT
#include <algorithm>

#include "sim/house/shell/faces.h"
#include "sim/house/shell/room_shell.h"

namespace bulletnav::sim::shell {
namespace {

constexpr float kBaseboardDepth = 0.014f;
constexpr float kLedgeHeight = 0.03f;
constexpr float kLedgeDepth = 0.022f;
constexpr float kCrownSize = 0.08f;

void SortUnique(std::vector<float>* values) {
  std::sort(values->begin(), values->end());
  values->erase(std::unique(values->begin(), values->end()), values->end());
}

/// One side in its own frame.
class SideBuilder {
 public:
  SideBuilder(const Side& side, const RoomStyle& style, float ceiling, MeshBuilder* builder)
      : side_(side),
        style_(style),
        finish_(style.WallAt(side.edge)),
        ceiling_(ceiling),
        builder_(builder) {}

  void Build() {
    const MeshBuilder::Frame frame(builder_, FaceFrame(side_.left, side_.right));
    AddFaces();
    if (style_.baseboard_height > 0.0f) {
      AddStrip(style_.baseboard, 0.0f, style_.baseboard_height, kBaseboardDepth);
    }
    if (finish_.has_cap) {
      AddStrip(style_.baseboard, finish_.split - kLedgeHeight, finish_.split, kLedgeDepth);
    }
    if (style_.crown) AddCrown(*style_.crown);
  }

 private:
  /// The wall cut along all jambs, sills and heads, so that its pieces meet corner to corner.
  void AddFaces() {
    // Behind the wall that meets it in an inner corner a wall runs on, so that no crack shows.
    const float x_low = side_.left_is_hollow ? -kOverlap : 0.0f;
    const float x_high = side_.length() + (side_.right_is_hollow ? kOverlap : 0.0f);
    const float y_high = ceiling_ + kOverlap;
    std::vector<float> xs = {x_low, x_high};
    std::vector<float> ys = {-kOverlap, y_high};
    if (finish_.split > 0.0f && finish_.split < ceiling_) ys.push_back(finish_.split);
    for (const Hole& hole : side_.holes) {
      xs.insert(xs.end(), {hole.x0, hole.x1});
      ys.push_back(hole.top);
      if (hole.bottom > 0.0f) ys.push_back(hole.bottom);
    }
    SortUnique(&xs);
    SortUnique(&ys);
    for (std::size_t i = 0; i + 1 < xs.size(); ++i) {
      for (std::size_t j = 0; j + 1 < ys.size(); ++j) {
        const float x = 0.5f * (xs[i] + xs[i + 1]);
        const float y = 0.5f * (ys[j] + ys[j + 1]);
        if (IsHole(x, y)) continue;
        const Surface& surface = y < finish_.split ? finish_.lower : finish_.upper;
        AddPanel(surface, {xs[i], ys[j], xs[i + 1], ys[j + 1]}, 0.0f, builder_);
      }
    }
  }

  bool IsHole(float x, float y) const {
    return std::any_of(side_.holes.begin(), side_.holes.end(), [&](const Hole& hole) {
      return x > hole.x0 && x < hole.x1 && y > hole.bottom && y < hole.top;
    });
  }

  /// A board along the wall, interrupted by holes and their casings at its height.
  void AddStrip(const Surface& surface, float low, float high, float depth) {
    float from = side_.left_is_hollow ? 0.0f : -depth;
    const float end = side_.length() + (side_.right_is_hollow ? 0.0f : depth);
    for (const Hole& hole : side_.holes) {
      if (high <= hole.bottom || low >= hole.top) continue;
      const float casing = hole.is_cased ? kCasingWidth : 0.0f;
      AddStripPart(surface, {from, low, hole.x0 - casing, high}, depth);
      from = hole.x1 + casing;
    }
    AddStripPart(surface, {from, low, end, high}, depth);
  }

  void AddStripPart(const Surface& surface, const Panel& panel, float depth) {
    if (panel.x1 - panel.x0 < 0.005f) return;
    AddBoard(surface, panel, 0.0f, depth, Grain::kLevel, builder_);
  }

  /// A slanted face under the ceiling, mitred in the corners.
  void AddCrown(const Surface& surface) {
    const float left = side_.left_is_hollow ? kCrownSize : -kCrownSize;
    const float right = side_.right_is_hollow ? kCrownSize : -kCrownSize;
    const float low = ceiling_ - kCrownSize;
    const float length = side_.length();
    builder_->Quad(surface, {0.0f, low, 0.0f}, {length, low, 0.0f},
                   {length - right, ceiling_, kCrownSize}, {left, ceiling_, kCrownSize});
  }

  const Side& side_;
  const RoomStyle& style_;
  const WallFinish& finish_;
  float ceiling_;
  MeshBuilder* builder_;
};

}  // namespace

void AddWalls(const FloorPlan& plan, const HouseStyle& style, int room, MeshBuilder* builder) {
  const RoomStyle& room_style = style.rooms[static_cast<std::size_t>(room)];
  for (const Side& side : SidesOf(plan, style, room)) {
    builder->BeginObject("wall", plan.rooms[static_cast<std::size_t>(room)].name);
    SideBuilder(side, room_style, plan.ceiling, builder).Build();
  }
}

}  // namespace bulletnav::sim::shell
