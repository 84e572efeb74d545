// SPDX-License-Identifier: MIT
#include "sim/house/building/hall.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace bulletnav::sim::building {
namespace {

constexpr float kQuarter = 0.5f * kHalfTurn;

/// Places about `pitch` apart, centred between two ends; one at least.
std::vector<float> Even(float low, float high, float pitch) {
  constexpr float kSqueeze = 0.25f;  // of a place may be missing
  const int count = std::max(1, static_cast<int>(std::floor((high - low) / pitch + kSqueeze)));
  std::vector<float> places;
  places.reserve(static_cast<std::size_t>(count));
  const float share = (high - low) / static_cast<float>(count);
  for (int i = 0; i < count; ++i) places.push_back(low + share * (static_cast<float>(i) + 0.5f));
  return places;
}

}  // namespace

Hall::Hall(RoomFurnisher* room) : room_(room) {
  const placing::Rect& floor = room->space().main_floor();
  origin_ = floor.min();
  along_x_ = floor.sizes().x() >= floor.sizes().y();
  length_ = floor.sizes().maxCoeff();
  width_ = floor.sizes().minCoeff();
}

PlanPoint Hall::At(float u, float v) const {
  return origin_ + (along_x_ ? PlanPoint(u, v) : PlanPoint(v, u));
}

float Hall::Turn(Look look) const {
  // A piece looks along its z, the plan's second axis; a turn by a quarter takes z to x.
  switch (look) {
    case Look::kUp:
      return along_x_ ? 0.0f : kQuarter;
    case Look::kDown:
      return along_x_ ? kHalfTurn : -kQuarter;
    case Look::kRight:
      return along_x_ ? kQuarter : 0.0f;
    case Look::kLeft:
      return along_x_ ? -kQuarter : kHalfTurn;
  }
  return 0.0f;
}

const Placed* Hall::Put(std::string_view kind, float u, float v, Look look, const Wish& wish) {
  return room_->AtPlace(kind, At(u, v), Turn(look), wish);
}

const Placed* Hall::Scatter(std::string_view kind, const Field& field, const Wish& wish) {
  static constexpr std::array kLooks = {Look::kUp, Look::kDown, Look::kRight, Look::kLeft};
  const float u = field.u0 + static_cast<float>(rng()->Uniform()) * (field.u1 - field.u0);
  const float v = field.v0 + static_cast<float>(rng()->Uniform()) * (field.v1 - field.v0);
  return Put(kind, u, v, rng()->Pick(kLooks), wish);
}

int Hall::Fill(const Rows& rows, const Field& field) {
  int count = 0;
  for (const float v : Even(field.v0, field.v1, rows.pitch)) count += FillRow(rows, field, v);
  return count;
}

int Hall::FillRow(const Rows& rows, const Field& field, float v) {
  constexpr float kBreak = 1.5f;  // metres
  int count = 0;
  float since_break = 0.0f;
  for (float u = field.u0; u + rows.width <= field.u1 + 1e-3f; u += rows.width + rows.gap) {
    if (rows.break_after > 0.0f && since_break >= rows.break_after) {
      since_break = 0.0f;
      u += kBreak;
      if (u + rows.width > field.u1) break;
    }
    since_break += rows.width;
    if (!rng()->Chance(static_cast<double>(rows.share))) continue;
    const Wish wish{.width = rows.width, .height = rows.height};
    const float middle = u + 0.5f * rows.width;
    if (Put(rows.kind, middle, v - 0.5f * rows.depth, Look::kUp, wish) != nullptr) ++count;
  }
  return count;
}

void Hall::Columns(float spacing) {
  room_->SetAlike(true);
  const float high = room_->space().ceiling();
  const int across = std::max(1, static_cast<int>(std::lround(width_ / spacing)));
  const int along = std::max(1, static_cast<int>(std::lround(length_ / spacing)));
  for (int cell = 0; cell < (along - 1) * (across - 1); ++cell) {
    const int row = 1 + cell / (along - 1);
    const auto i = static_cast<float>(1 + cell % (along - 1));
    const auto k = static_cast<float>(row);
    const float u = length_ * i / static_cast<float>(along);
    Put("column", u, width_ * k / static_cast<float>(across), Look::kUp, {.height = high});
  }
  room_->SetAlike(false);
}

void Hall::Lights(std::string_view kind, float spacing) {
  room_->SetAlike(true);
  const auto count = [&](float size) {
    return std::max(1, static_cast<int>(std::lround(size / spacing)));
  };
  const int along = count(length_);
  const int across = count(width_);
  for (int cell = 0; cell < along * across; ++cell) {
    const int row = cell / along;
    const auto i = static_cast<float>(cell % along);
    const auto k = static_cast<float>(row);
    const float u = length_ * (i + 0.5f) / static_cast<float>(along);
    const float v = width_ * (k + 0.5f) / static_cast<float>(across);
    // Beside a column or a beam that is in the way.
    if (!room_->HangAt(kind, At(u, v), Turn(Look::kUp))) {
      room_->HangAt(kind, At(std::min(u + 0.7f, length_ - 0.4f), v), Turn(Look::kUp));
    }
  }
  room_->SetAlike(false);
}

void Hall::AlongWalls(std::span<const std::string_view> kinds, int count, float width) {
  for (int i = 0; i < count; ++i) {
    room_->AgainstWall(room_->Pick(kinds), {.width = width, .min_width = 0.5f * width});
  }
}

}  // namespace bulletnav::sim::building
