// SPDX-License-Identifier: MIT
// Classrooms and halls of schools.
#include <algorithm>

#include "sim/house/furniture/families.h"
#include "sim/house/furniture/parts.h"

namespace bulletnav::sim::furniture {
namespace {

/// What the chairs and tables of one set are made of.
struct SchoolSet {
  Surface seat;
  Surface top;
  Surface frame;
};

SchoolSet DrawSet(PieceMaker& m) {
  SchoolSet set;
  const Surface plywood{"beech"};
  set.seat =
      m.Chance(0.5) ? plywood : Surface{"plastic", m.Chance(0.5) ? BrightColor(m) : MutedColor(m)};
  set.top = m.Chance(0.5) ? m.palette().wood : Surface{"plastic", {226, 222, 210}};
  set.frame = m.Chance(0.5) ? kGreyPlastic : Surface{"painted_wood", MutedColor(m)};
  return set;
}

/// A chair of board on tubes; its sitter at `at` looks to +z.
void SchoolChair(PieceMaker& m, const SchoolSet& set, const Vec& at, float yaw) {
  const Frame frame(&m, at, yaw);
  for (const float x : {-0.17f, 0.17f}) {
    for (const float z : {-0.17f, 0.15f}) Post(m, set.frame, {x, 0, z}, 0.025f, 0.43f);
    m.Box(set.frame, {x - 0.012f, 0.43f, -0.19f}, {x + 0.012f, 0.8f, -0.165f});
  }
  m.Box(set.seat, {-0.2f, 0.43f, -0.19f}, {0.2f, 0.455f, 0.2f});
  m.Box(set.seat, {-0.19f, 0.62f, -0.215f}, {0.19f, 0.82f, -0.19f});
}

/// A table with its chairs; pupils look to +z.
void SchoolDesk(PieceMaker& m) {
  const float width = m.Width(1.2f, 1.4f);
  const float half = 0.5f * width;
  const float high = m.Draw(0.68f, 0.76f);
  const float deep = m.Draw(0.5f, 0.6f);
  const SchoolSet set = DrawSet(m);
  m.Box(set.top, {-half, high - 0.025f, 0}, {half, high, deep});
  for (const float x : {-half + 0.05f, half - 0.05f}) {
    for (const float z : {0.05f, deep - 0.05f}) Post(m, set.frame, {x, 0, z}, 0.03f, high - 0.025f);
  }
  if (m.Chance(0.5))
    m.Box(set.frame, {-half + 0.05f, high - 0.3f, deep - 0.06f},
          {half - 0.05f, high - 0.03f, deep - 0.04f});
  const int pupils = width > 1.0f ? 2 : 1;
  for (int i = 0; i < pupils; ++i) {
    const float x = pupils == 1 ? 0.0f : half * (static_cast<float>(i) - 0.5f);
    const float back = m.Draw(0.0f, 0.2f);
    SchoolChair(m, set, {x, 0, -0.05f - back}, m.Draw(-0.15f, 0.15f));
    if (m.Chance(0.4)) {
      const Surface book{"cardboard", BrightColor(m)};
      m.Box(book, {x - 0.1f, high, 0.12f}, {x + 0.1f, high + m.Draw(0.01f, 0.05f), 0.38f});
    }
    if (m.Chance(0.3))
      m.Block({"canvas", BrightColor(m)}, {x + 0.1f * half, 0, 0.15f}, {0.24f, 0.38f, 0.2f});
  }
  m.AddTop(high, {-half, 0.0f}, {half, deep});
}

/// Chairs side by side, looking to +z.
void ChairRow(PieceMaker& m) {
  const float width = m.Width(1.6f, 2.4f, 0.0f);
  const SchoolSet set = DrawSet(m);
  const int chairs = std::max(1, static_cast<int>(width / 0.5f));
  const float share = width / static_cast<float>(chairs);
  for (int i = 0; i < chairs; ++i) {
    const float x = share * (static_cast<float>(i) + 0.5f) - 0.5f * width;
    SchoolChair(m, set, {x, 0, 0}, 0.0f);
  }
  // Joined under the seats, from end to end.
  m.Box(set.frame, {-0.5f * width, 0.4f, -0.02f}, {0.5f * width, 0.43f, 0.02f});
}

/// Slate with a tray, or with two wings.
void Blackboard(PieceMaker& m) {
  const float half = 0.5f * m.Width(1.8f, 2.5f);
  const float high = m.Draw(1.0f, 1.2f);
  const Surface rim = m.Chance(0.5) ? m.palette().wood : kGreyPlastic;
  const Surface slate = m.Chance(0.5) ? Surface{"blackboard"} : Surface{"plastic", {38, 72, 56}};
  m.Box(rim, {-half, 0, 0}, {half, high, 0.03f});
  const int leaves = m.Chance(0.5) ? 3 : 1;
  const float edge = 0.04f;
  const std::array<float, 4> cuts = {-half + edge, leaves == 3 ? -0.5f * half : half - edge,
                                     0.5f * half, half - edge};
  for (int i = 0; i < leaves; ++i) {
    const auto k = static_cast<std::size_t>(i);
    Panel(m, slate, {cuts[k] + 0.005f, edge, 0.03f}, {cuts[k + 1] - 0.005f, high - edge, 0.045f});
  }
  m.Box(rim, {-0.8f * half, 0.0f, 0.03f}, {0.8f * half, 0.03f, 0.12f});
  for (int i = 0; i < 5; ++i) {  // what was left standing
    const float x = m.Draw(-0.45f, 0.25f) * half;
    const float y = m.Draw(0.25f, 0.85f) * high;
    Panel(m, kWhitePlastic, {x, y, 0.045f}, {x + m.Draw(0.08f, 0.2f) * half, y + 0.015f, 0.047f});
  }
}

/// Pulled down from its case.
void ProjectorScreen(PieceMaker& m) {
  const float half = 0.5f * m.Width(1.6f, 2.4f);
  const float high = m.Draw(1.2f, 1.5f);
  m.Box(kWhitePaint, {-half, high, 0}, {half, high + 0.1f, 0.1f});
  m.Box(kDark, {-half + 0.06f, 0, 0.03f}, {half - 0.06f, high, 0.045f});
  Panel(m, {"paper"}, {-half + 0.12f, 0.06f, 0.045f}, {half - 0.12f, high - 0.05f, 0.048f});
}

void Lectern(PieceMaker& m) {
  const float half = 0.5f * m.Draw(0.55f, 0.7f);
  const Surface wood = m.Chance(0.6) ? m.palette().wood : m.palette().cabinet;
  const float high = m.Draw(1.0f, 1.15f);
  m.Box(wood, {-half, 0, -0.25f}, {half, 0.05f, 0.25f});
  m.Box(wood, {-half + 0.04f, 0.05f, -0.05f}, {half - 0.04f, high - 0.1f, 0.22f});
  m.TaperedBox(wood, {0, high - 0.1f, 0}, {2.0f * half, 0.5f}, {0, high, 0.06f},
               {2.0f * half, 0.36f});
  if (m.Chance(0.5))
    m.Bar(kBlackMetal, {0.1f, high - 0.02f, 0.1f}, {0.08f, high + 0.25f, -0.05f}, 0.012f, 4);
}

/// Boards between posts, to climb on.
void WallBars(PieceMaker& m) {
  const float width = m.Width(0.9f, 1.9f);
  const float half = 0.5f * width;
  const float high = m.Draw(2.1f, 2.35f);
  const int fields = std::max(1, static_cast<int>(width / 0.9f));
  const Surface wood{m.Chance(0.5) ? "beech" : "pine"};
  for (int i = 0; i <= fields; ++i) {
    const float x =
        -half + 0.025f + (width - 0.05f) * static_cast<float>(i) / static_cast<float>(fields);
    m.Box(wood, {x - 0.025f, 0, 0}, {x + 0.025f, high, 0.12f});
  }
  for (const float y : Spaced(0.15f, high - 0.05f, 0.17f)) {
    m.Box(wood, {-half + 0.03f, y, 0.08f}, {half - 0.03f, y + 0.04f, 0.115f});
  }
}

/// Boxes of boards that narrow upwards, padded on top.
void VaultingBox(PieceMaker& m) {
  const int levels = m.Between(3, 5);
  const Surface wood{m.Chance(0.5) ? "pine" : "beech"};
  constexpr float kLevel = 0.2f;
  for (int i = 0; i < levels; ++i) {
    const float y = kLevel * static_cast<float>(i);
    const float w = 1.45f - 0.07f * static_cast<float>(i);
    const float d = 0.75f - 0.06f * static_cast<float>(i);
    m.TaperedBox(wood, {0, y, 0}, {w, d}, {0, y + kLevel - 0.012f, 0}, {w - 0.06f, d - 0.05f});
  }
  const float top = kLevel * static_cast<float>(levels);
  const float w = 1.42f - 0.07f * static_cast<float>(levels);
  const float d = 0.7f - 0.06f * static_cast<float>(levels);
  Cushion(m, {"leather", m.Chance(0.5) ? Rgb8{120, 80, 50} : MutedColor(m)},
          {-0.5f * w, top - 0.012f, -0.5f * d}, {0.5f * w, top + 0.1f, 0.5f * d}, 0.03f);
}

void GymMats(PieceMaker& m) {
  const int mats = m.Between(2, 6);
  const Surface cover{"leather", BrightColor(m)};
  const float thick = m.Draw(0.07f, 0.12f);
  for (int i = 0; i < mats; ++i) {
    const float x = m.Draw(-0.05f, 0.05f);
    const float y = thick * static_cast<float>(i);
    m.Box(i % 2 == 0 ? cover : Shaded(cover, 0.85f), {-0.95f + x, y, -0.55f},
          {0.95f + x, y + thick - 0.01f, 0.55f});
  }
}

/// A board with a ring, high on a wall.
void BasketballHoop(PieceMaker& m) {
  const float half = 0.5f * m.Draw(1.1f, 1.6f);
  const float high = m.Draw(0.8f, 1.0f);
  m.Box(kWhitePaint, {-half, 0, 0.05f}, {half, high, 0.09f});
  for (const float x : {-0.6f * half, 0.6f * half})
    m.Box(kBlackMetal, {x - 0.03f, 0.1f, 0}, {x + 0.03f, high - 0.1f, 0.05f});
  const Surface lines{"plastic", {200, 60, 40}};
  Panel(m, lines, {-0.3f, 0.12f, 0.09f}, {0.3f, 0.16f, 0.095f});
  Panel(m, lines, {-0.3f, 0.53f, 0.09f}, {0.3f, 0.57f, 0.095f});
  for (const float x : {-0.3f, 0.26f})
    Panel(m, lines, {x, 0.16f, 0.09f}, {x + 0.04f, 0.53f, 0.095f});
  const Frame frame(&m, Turned({0, 0.14f, 0.27f}, kQuarterTurn, 0.0f, kQuarterTurn));
  Hoop(m, lines, {0, 0, 0}, 0.15f, 0.02f, 10);
}

constexpr std::array kKinds = {
    FurnitureKind{"basketball_hoop", Placement::kOnWall, 0.0f, BasketballHoop},
    FurnitureKind{"blackboard", Placement::kOnWall, 0.0f, Blackboard, 1.4f, 4.2f},
    FurnitureKind{"chair_row", Placement::kFree, 0.3f, ChairRow, 1.0f, 4.0f},
    FurnitureKind{"gym_mats", Placement::kFree, 0.1f, GymMats},
    FurnitureKind{"lectern", Placement::kFree, 0.4f, Lectern},
    FurnitureKind{"projector_screen", Placement::kOnWall, 0.0f, ProjectorScreen, 1.4f, 3.2f},
    FurnitureKind{"school_desk", Placement::kFree, 0.3f, SchoolDesk, 0.7f, 1.6f},
    FurnitureKind{"vaulting_box", Placement::kFree, 0.3f, VaultingBox},
    FurnitureKind{"wall_bars", Placement::kAgainstWall, 0.6f, WallBars, 0.8f, 3.6f}};

}  // namespace

std::span<const FurnitureKind> School() {
  return kKinds;
}

}  // namespace bulletnav::sim::furniture
