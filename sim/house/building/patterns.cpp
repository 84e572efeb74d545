// SPDX-License-Identifier: MIT
#include "sim/house/building/patterns.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/base/elementary.h"
#include "sim/house/building/rooms.h"

namespace bulletnav::sim::building {
namespace {

constexpr std::array kLooks = {Look::kUp, Look::kDown, Look::kRight, Look::kLeft};

Look Nearest(const Hall& hall, const PlanPoint& way) {
  const auto along = [&](Look look) {
    const float turn = hall.Turn(look);
    return way.dot(PlanPoint(Sin(turn), Cos(turn)));
  };
  return *std::max_element(kLooks.begin(), kLooks.end(), [&](Look a, Look b) {
    return along(a) < along(b);
  });
}

bool IsAlong(Look look) {
  return look == Look::kRight || look == Look::kLeft;
}

/// Puts a piece `away` from the wall that it looks at and `aside` along that wall.
const Placed* PutBefore(Hall* hall, Look look, float away, float aside, const Audience& audience) {
  const float size = IsAlong(look) ? hall->length() : hall->width();
  const float at = look == Look::kUp || look == Look::kRight ? size - away : away;
  const placing::Wish wish{.width = audience.width};
  return IsAlong(look) ? hall->Put(audience.kind, at, aside, look, wish)
                       : hall->Put(audience.kind, aside, at, look, wish);
}

}  // namespace

Look LookTowards(const Hall& hall, const PlanPoint& target) {
  return Nearest(hall, target - hall.At(0.5f * hall.length(), 0.5f * hall.width()));
}

Look LookOf(const Hall& hall, const Placed& piece) {
  const Eigen::Vector3f front = piece.pose.linear().col(2);
  return Nearest(hall, {front.x(), front.z()});
}

Look Opposite(Look look) {
  switch (look) {
    case Look::kUp:
      return Look::kDown;
    case Look::kDown:
      return Look::kUp;
    case Look::kRight:
      return Look::kLeft;
    case Look::kLeft:
      break;
  }
  return Look::kRight;
}

int Seat(Hall* hall, Look look, const Audience& audience) {
  const float deep = IsAlong(look) ? hall->length() : hall->width();
  const float wide = IsAlong(look) ? hall->width() : hall->length();
  const float span = wide - 2.0f * audience.side - audience.aisle;
  const int places = static_cast<int>((span + audience.gap) / (audience.width + audience.gap));
  if (places < 1) return 0;
  const float taken =
      static_cast<float>(places) * (audience.width + audience.gap) - audience.gap + audience.aisle;
  const float begin = 0.5f * (wide - taken);
  const auto rows =
      1 + static_cast<int>(std::floor((deep - audience.first - audience.last) / audience.pitch));
  int count = 0;
  for (int i = 0; i < rows * places; ++i) {
    const int row = i / places;
    const int place = i % places;
    if (!hall->rng()->Chance(audience.share)) continue;
    const float away = audience.first + audience.pitch * static_cast<float>(row);
    float aside = begin + static_cast<float>(place) * (audience.width + audience.gap);
    if (2 * place >= places) aside += audience.aisle;
    aside += 0.5f * audience.width;
    if (PutBefore(hall, look, away, aside, audience) != nullptr) ++count;
  }
  return count;
}

std::vector<const Placed*> LineWalls(RoomFurnisher* room, std::string_view kind, float pitch,
                                     int most) {
  std::vector<shell::Side> sides = room->space().sides();
  std::stable_sort(sides.begin(), sides.end(), [](const shell::Side& a, const shell::Side& b) {
    return a.length() > b.length();
  });
  if (room->Chance(0.5) && sides.size() > 1) std::swap(sides[0], sides[1]);
  std::vector<const Placed*> placed;
  for (const shell::Side& side : sides) {
    const int places = static_cast<int>((side.length() - 0.1f) / pitch);
    const float begin = 0.5f * (side.length() - static_cast<float>(places) * pitch);
    for (int i = 0; i < places; ++i) {
      if (static_cast<int>(placed.size()) >= most) return placed;
      const float x = begin + pitch * (static_cast<float>(i) + 0.5f);
      if (const Placed* piece = room->AtWall(side, x, kind, {})) placed.push_back(piece);
    }
  }
  return placed;
}

void GlazedWall(Hall* hall, float u) {
  constexpr float kWay = 1.3f;  // metres
  constexpr float kMost = 3.6f;
  RoomFurnisher& room = hall->room();
  room.SetAlike(true);
  const float way = Draw(hall->rng(), 0.1, 0.9) * (hall->width() - kWay);
  const std::array<std::pair<float, float>, 2> parts = {std::pair{0.03f, way},
                                                        {way + kWay, hall->width() - 0.03f}};
  for (const auto& [low, high] : parts) {
    const auto panes = static_cast<int>(std::ceil((high - low) / kMost));
    if (high - low < 0.8f) continue;
    const float width = (high - low) / static_cast<float>(panes);
    for (int i = 0; i < panes; ++i) {
      hall->Put("glass_screen", u, low + width * (static_cast<float>(i) + 0.5f), Look::kRight,
                {.width = width - 0.01f, .height = room.space().ceiling() - 0.01f});
    }
  }
  room.SetAlike(false);
}

void Tables(Hall* hall, std::string_view table, float width, const Field& field) {
  RoomFurnisher& room = hall->room();
  room.SetAlike(true);
  constexpr float kAcross = 2.1f;  // metres; with chairs and a way
  const float along = width + 1.0f;
  const auto columns = std::max(1, static_cast<int>((field.u1 - field.u0) / along));
  const auto rows = std::max(1, static_cast<int>((field.v1 - field.v0) / kAcross));
  for (int i = 0; i < rows * columns; ++i) {
    const int row = i / columns;
    const float k = (static_cast<float>(i % columns) + 0.5f) / static_cast<float>(columns);
    const float r = (static_cast<float>(row) + 0.5f) / static_cast<float>(rows);
    const Placed* placed =
        hall->Put(table, field.u0 + k * (field.u1 - field.u0), field.v0 + r * (field.v1 - field.v0),
                  Look::kUp, {.width = width});
    if (placed != nullptr) room.ChairsAround(*placed, "dining_chair", width > 1.5f ? 6 : 4);
  }
  room.SetAlike(false);
}

void FurnishWetCell(RoomFurnisher* room) {
  room->SetAlike(true);
  const placing::Wish in_corner{.anchor = placing::Anchor::kEnd, .squeeze = true};
  room->InCorner("shower_cabin");
  room->AgainstWall("toilet", in_corner);
  // Basins bring their mirrors.
  if (room->AgainstWall("washbasin", {.width = 0.6f, .squeeze = true}) == nullptr) {
    room->AgainstWall("pedestal_basin", {.squeeze = true});
  }
  room->OnWall("towel_rail", 0.75f);
  room->NearWall("bin");
  room->SetAlike(false);
  room->DressWindows(false);
  room->Light("ceiling_lamp");
}

void FurnishCanteen(RoomFurnisher* room) {
  Hall hall(room);
  if (room->area() > 110.0f) hall.Columns(Draw(hall.rng(), 5.5, 7.5));
  const int buffets = 1 + static_cast<int>(room->area() / 60.0f);
  for (int i = 0; i < buffets; ++i) {
    room->AgainstWall("buffet_counter", {.width = 3.2f, .min_width = 1.4f});
  }
  if (room->Chance(0.5)) room->AgainstWall("vending_machine");
  Field field = hall.Inner(0.7f);
  if (hall.length() > 11.0f && room->Chance(0.5)) {
    const float u = Draw(hall.rng(), 0.25, 0.35) * hall.length();
    GlazedWall(&hall, u);
    field.u0 = u + 0.8f;
  }
  const bool is_round = room->Chance(0.35);
  Tables(&hall, is_round ? "round_dining_table" : "dining_table",
         is_round ? 1.1f : (room->Chance(0.5) ? 1.3f : 1.8f), field);
  room->NearWall("bin");
  room->NearWall(room->Chance(0.5) ? "tall_plant" : "potted_plant");
  for (int i = 0; i < 2; ++i) room->OnWall(room->Chance(0.5) ? "painting" : "poster");
  room->OnWall("exit_sign", 2.1f);
  FinishRoom(room);
}

}  // namespace bulletnav::sim::building
