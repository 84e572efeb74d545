// SPDX-License-Identifier: MIT
// Desks, tables and machines of offices, simple enough for a hundred of them in one hall.
#include <algorithm>
#include <cmath>

#include "sim/house/furniture/families.h"
#include "sim/house/furniture/parts.h"

namespace bulletnav::sim::furniture {
namespace {

constexpr float kDeskTop = 0.73f;

/// What all workplaces of one piece share.
struct Workplace {
  Surface top;
  Surface cloth;
  Surface frame;
  bool has_pedestal = true;
};

Workplace DrawWorkplace(PieceMaker& m) {
  Workplace w;
  w.top = m.Chance(0.5) ? m.palette().wood : m.palette().counter;
  w.cloth = m.Chance(0.5) ? Surface{"canvas", {56, 58, 62}} : m.palette().fabric;
  w.frame = m.Chance(0.5) ? m.palette().metal : kGreyPlastic;
  w.has_pedestal = m.Chance(0.6);
  return w;
}

/// A chair on castors; its sitter at the origin looks to -z.
void TaskChair(PieceMaker& m, const Workplace& w, const Vec& at, float yaw) {
  const Frame frame(&m, at, yaw);
  m.Cylinder(kBlackPlastic, {0, 0.04f, 0}, 0.03f, 0.38f, 5);
  for (const float turn : {0.0f, kQuarterTurn}) {
    const Frame cross(&m, {0, 0, 0}, turn);
    m.Box(kBlackPlastic, {-0.27f, 0.02f, -0.03f}, {0.27f, 0.07f, 0.03f});
  }
  m.Box(w.cloth, {-0.23f, 0.42f, -0.22f}, {0.23f, 0.49f, 0.22f});
  m.Box(w.cloth, {-0.21f, 0.56f, 0.19f}, {0.21f, 0.98f, 0.25f});
  m.Box(kBlackPlastic, {-0.03f, 0.44f, 0.2f}, {0.03f, 0.6f, 0.24f});
}

/// A desk whose back lies in z = 0 with what stands on it, its sitter before it at larger z.
void DeskSet(PieceMaker& m, const Workplace& w, float x0, float x1, float depth) {
  m.Box(w.top, {x0, kDeskTop - 0.03f, 0}, {x1, kDeskTop, depth});
  for (const float x : {x0 + 0.03f, x1 - 0.03f}) {
    m.Box(w.frame, {x - 0.02f, 0, 0.05f}, {x + 0.02f, kDeskTop - 0.03f, depth - 0.05f});
  }
  const float middle = 0.5f * (x0 + x1);
  if (w.has_pedestal) {
    m.Box(w.frame, {x0 + 0.06f, 0.02f, 0.1f}, {x0 + 0.46f, 0.62f, depth - 0.06f});
  }
  const int screens = m.Chance(0.3) ? 2 : 1;
  for (int i = 0; i < screens; ++i) {
    const float x =
        middle + (screens == 1 ? m.Draw(-0.15f, 0.15f) : 0.6f * static_cast<float>(i) - 0.3f);
    m.Box(kBlackPlastic, {x - 0.1f, kDeskTop, 0.1f}, {x + 0.1f, kDeskTop + 0.13f, 0.2f});
    m.Box(kBlackPlastic, {x - 0.28f, kDeskTop + 0.11f, 0.13f},
          {x + 0.28f, kDeskTop + 0.45f, 0.16f});
    Sheet(m, {"computer_screen"}, {x, kDeskTop + 0.13f, 0.164f}, 0.53f, 0.3f);
  }
  m.Box(kBlackPlastic, {middle - 0.21f, kDeskTop, depth - 0.25f},
        {middle + 0.21f, kDeskTop + 0.02f, depth - 0.1f});
  if (m.Chance(0.6)) {
    const float x = m.Chance(0.5) ? x0 + 0.2f : x1 - 0.2f;
    const Surface things = m.Chance(0.5) ? kPaper : Surface{"cardboard", MutedColor(m)};
    m.Box(things, {x - 0.12f, kDeskTop, 0.3f},
          {x + 0.12f, kDeskTop + m.Draw(0.01f, 0.2f), 0.6f * depth + 0.1f});
  }
}

/// A place to work with screens of cloth on three sides, open to the front.
void Cubicle(PieceMaker& m) {
  const float half = 0.5f * m.Width(1.7f, 2.1f);
  const float deep = m.Draw(1.7f, 1.9f);
  const float high = m.Draw(1.2f, 1.6f);
  const Workplace w = DrawWorkplace(m);
  const Surface screen = m.Chance(0.6) ? m.palette().fabric : m.palette().accent;
  constexpr float kThick = 0.05f;
  m.Box(screen, {-half, 0, 0}, {half, high, kThick});
  for (const float x : {-half, half - kThick})
    m.Box(screen, {x, 0, kThick}, {x + kThick, high, deep});
  {
    const Frame frame(&m, {0, 0, kThick});
    DeskSet(m, w, -half + kThick, half - kThick, 0.72f);
  }
  if (m.Chance(0.5)) {  // the desk turns the corner
    m.Box(w.top, {half - kThick - 0.5f, kDeskTop - 0.03f, 0.77f},
          {half - kThick, kDeskTop, deep - 0.1f});
    m.Box(w.frame, {half - kThick - 0.46f, 0, 0.9f}, {half - kThick, 0.66f, deep - 0.12f});
  }
  const float seat = m.Draw(-0.2f, 0.1f);
  TaskChair(m, w, {seat, 0, 1.1f}, m.Draw(-0.5f, 0.5f));
  m.AddTop(kDeskTop, {-half + 0.1f, 0.1f}, {half - 0.1f, 0.7f});
}

/// Two desks whose sitters face each other, with a low screen between them.
void DeskPair(PieceMaker& m) {
  const float half = 0.5f * m.Width(1.4f, 1.8f);
  const float depth = m.Draw(0.64f, 0.72f);
  const float screen = m.Draw(1.0f, 1.35f);
  const Workplace w = DrawWorkplace(m);
  m.Box(m.palette().fabric, {-half, 0.4f, -0.02f}, {half, screen, 0.02f});
  for (const float yaw : {0.0f, 2.0f * kQuarterTurn}) {
    const Frame frame(&m, {0, 0, 0}, yaw);
    const Frame behind(&m, {0, 0, 0.02f});
    DeskSet(m, w, -half, half, depth);
    const float seat = m.Draw(-0.2f, 0.2f);
    const float away = m.Draw(-0.1f, 0.04f);
    TaskChair(m, w, {seat, 0, depth + away}, m.Draw(-0.4f, 0.4f));
  }
}

/// A long table with chairs around it.
void MeetingTable(PieceMaker& m) {
  const float width = m.Width(1.9f, 2.5f, 0.05f);
  const float half = 0.5f * width;
  const float deep = 0.5f * m.Draw(1.0f, 1.25f);
  const Workplace w = DrawWorkplace(m);
  m.Box(w.top, {-half, 0.7f, -deep}, {half, 0.74f, deep});
  for (const float x : {-0.6f * half, 0.6f * half})
    m.Block(w.frame, {x, 0, 0}, {0.12f, 0.7f, 1.1f * deep});
  const auto seats = std::max(2, static_cast<int>(width / 0.72f));
  for (int i = 0; i < seats; ++i) {
    const float x = width * ((static_cast<float>(i) + 0.5f) / static_cast<float>(seats) - 0.5f);
    for (const float side : {-1.0f, 1.0f}) {
      const float z = side * (deep + 0.17f);
      TaskChair(m, w, {x, 0, z}, (side > 0.0f ? 0.0f : 2.0f * kQuarterTurn) + m.Draw(-0.2f, 0.2f));
    }
  }
  m.AddTop(0.74f, {-half + 0.1f, -deep + 0.1f}, {half - 0.1f, deep - 0.1f});
}

void Copier(PieceMaker& m) {
  const float half = 0.5f * m.Draw(0.58f, 0.7f);
  const float high = m.Draw(0.95f, 1.1f);
  const Surface body = m.Chance(0.6) ? kWhitePlastic : kGreyPlastic;
  m.Box(body, {-half, 0, 0}, {half, high, 0.62f});
  m.Box(kBlackPlastic, {-half + 0.02f, high, 0.05f}, {half - 0.02f, high + 0.12f, 0.55f});
  for (const float y : {0.1f, 0.32f, 0.54f})
    Panel(m, kGreyPlastic, {-half + 0.03f, y, 0.62f}, {half - 0.03f, y + 0.18f, 0.635f});
  m.Box(kBlackPlastic, {half - 0.28f, high, 0.55f}, {half - 0.03f, high + 0.05f, 0.7f});
}

void Whiteboard(PieceMaker& m) {
  const float half = 0.5f * m.Width(1.4f, 2.2f);
  const float high = m.Draw(1.0f, 1.2f);
  m.Box(kGreyPlastic, {-half, 0, 0}, {half, high, 0.02f});
  Panel(m, {"ceramic"}, {-half + 0.03f, 0.03f, 0.02f}, {half - 0.03f, high - 0.03f, 0.024f});
  m.Box(kGreyPlastic, {-0.5f * half, 0, 0.02f}, {0.5f * half, 0.02f, 0.08f});
  for (int i = 0; i < 4; ++i) {  // what was left standing
    const float x = m.Draw(-0.85f, 0.5f) * half;
    const float y = m.Draw(0.2f, 0.8f) * high;
    const Surface ink{"plastic", BrightColor(m)};
    Panel(m, ink, {x, y, 0.024f}, {x + m.Draw(0.1f, 0.3f), y + 0.02f, 0.026f});
  }
}

/// Cabinets with shut doors, chest-high or man-high.
void Credenza(PieceMaker& m) {
  const float width = m.Width(1.2f, 2.2f);
  const float half = 0.5f * width;
  const float high = m.Chance(0.5) ? m.Draw(0.75f, 1.15f) : m.Draw(1.7f, 2.0f);
  const Surface body = m.Chance(0.5) ? m.palette().cabinet : m.palette().wood;
  Body(m, body, {-half, 0, 0}, {half, high, 0.43f});
  Doors(m, body, {-half, half, 0.06f, high - 0.02f, 0.43f},
        std::max(2, static_cast<int>(width / 0.5f)));
  m.AddTop(high, {-half, 0.0f}, {half, 0.42f});
}

constexpr std::array kKinds = {
    FurnitureKind{"copier", Placement::kAgainstWall, 0.7f, Copier},
    FurnitureKind{"credenza", Placement::kAgainstWall, 0.6f, Credenza, 0.8f, 3.2f},
    FurnitureKind{"cubicle", Placement::kAgainstWall, 0.6f, Cubicle, 1.6f, 2.4f},
    FurnitureKind{"desk_pair", Placement::kFree, 0.5f, DeskPair, 1.3f, 2.0f},
    FurnitureKind{"meeting_table", Placement::kFree, 0.5f, MeetingTable, 1.6f, 6.0f},
    FurnitureKind{"whiteboard", Placement::kOnWall, 0.0f, Whiteboard, 1.0f, 3.2f}};

}  // namespace

std::span<const FurnitureKind> Workplaces() {
  return kKinds;
}

}  // namespace bulletnav::sim::furniture
