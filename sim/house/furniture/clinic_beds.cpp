// SPDX-License-Identifier: MIT
// What patients lie on in clinics and hospitals, and what stands around it.
#include "sim/house/furniture/families.h"
#include "sim/house/furniture/parts.h"

namespace bulletnav::sim::furniture {
namespace {

Surface Covering(PieceMaker& m) {
  static constexpr std::array<Rgb8, 5> kColors = {Rgb8{70, 96, 120}, Rgb8{48, 52, 58},
                                                  Rgb8{96, 140, 132}, Rgb8{150, 96, 84},
                                                  Rgb8{196, 190, 176}};
  return {"leather", m.rng().Pick(kColors)};
}

/// Four castors under the rectangle from `low` to `high` (x, z).
void Castors(PieceMaker& m, const Vec2& low, const Vec2& high) {
  constexpr float kRadius = 0.065f;
  for (const float x : {low.x(), high.x()}) {
    for (const float z : {low.y(), high.y()}) {
      m.Box(kRubber, {x - 0.02f, 0, z - kRadius}, {x + 0.02f, 2.0f * kRadius, z + kRadius});
    }
  }
}

/// A rail of bars along z at x, from y0 to y1.
void SideRail(PieceMaker& m, const Surface& surface, float x, const Vec2& along, const Vec2& up) {
  for (const float y : {up.x(), up.y()}) {
    m.Box(surface, {x - 0.012f, y - 0.015f, along.x()}, {x + 0.012f, y + 0.015f, along.y()});
  }
  for (const float z : Spaced(along.x() + 0.02f, along.y(), 0.16f)) {
    m.Box(surface, {x - 0.01f, up.x(), z - 0.01f}, {x + 0.01f, up.y(), z + 0.01f});
  }
}

/// Mattress, blanket and pillow between z0 and z1.
void Bedclothes(PieceMaker& m, float half, float base, const Vec2& along) {
  const float top = base + 0.14f;
  Cushion(m, kWhiteLinen, {-half, base, along.x()}, {half, top, along.y()}, 0.02f);
  const Surface blanket =
      m.Chance(0.5) ? kWhiteLinen
                    : Surface{"linen", m.Chance(0.5) ? MutedColor(m) : Rgb8{158, 190, 208}};
  const float fold = along.x() + m.Draw(0.6f, 0.9f);
  m.Box(blanket, {-half - 0.015f, top - 0.12f, fold},
        {half + 0.015f, top + 0.03f, along.y() - 0.02f});
  const Frame frame(&m, {0, top, along.x() + 0.26f});
  Pillow(m, kWhiteLinen, {-0.28f, 0, -0.19f}, {0.28f, 0.11f, 0.19f});
}

/// Low enough for a window above its head.
void HospitalBed(PieceMaker& m) {
  const float half = 0.5f * m.Draw(0.9f, 0.98f);
  const float base = m.Draw(0.42f, 0.5f);
  constexpr float kEnd = 2.12f;
  const Surface steel = m.Chance(0.6) ? kWhitePaint : kGreyPlastic;
  const Surface board{"plastic", m.Chance(0.5) ? Rgb8{222, 206, 176} : Rgb8{196, 210, 220}};
  Castors(m, {-half + 0.1f, 0.2f}, {half - 0.1f, kEnd - 0.2f});
  m.Box(kGreyPlastic, {-half + 0.15f, 0.1f, 0.15f}, {half - 0.15f, 0.2f, kEnd - 0.15f});
  for (const float z : {0.5f, kEnd - 0.6f})
    m.Block(kGreyPlastic, {0, 0.2f, z}, {0.4f, base - 0.26f, 0.25f});
  m.Box(steel, {-half, base - 0.06f, 0.05f}, {half, base, kEnd - 0.05f});
  m.Box(board, {-half, base - 0.1f, 0}, {half, 0.75f, 0.05f});
  m.Box(board, {-half, base - 0.1f, kEnd - 0.05f}, {half, m.Draw(0.66f, 0.74f), kEnd});
  Bedclothes(m, half - 0.03f, base, {0.06f, kEnd - 0.07f});
  for (const float x : {-half + 0.012f, half - 0.012f}) {
    SideRail(m, steel, x, {0.45f, m.Chance(0.5) ? 1.55f : 1.2f}, {base + 0.1f, 0.74f});
  }
}

/// Its length lies along x, so that it stands along walls.
void Gurney(PieceMaker& m) {
  const Frame along(&m, {0, 0, 0}, kQuarterTurn);
  const float half = 0.5f * m.Draw(0.62f, 0.7f);
  const float base = m.Draw(0.68f, 0.78f);
  constexpr float kEnd = 0.96f;
  Castors(m, {-half + 0.06f, -kEnd + 0.15f}, {half - 0.06f, kEnd - 0.15f});
  for (const float x : {-half + 0.06f, half - 0.06f}) {
    for (const float z : {-kEnd + 0.15f, kEnd - 0.15f}) {
      Post(m, kSteel, {x, 0.1f, z}, 0.035f, base - 0.1f);
    }
  }
  m.Box(kSteel, {-half + 0.04f, 0.3f, -kEnd + 0.13f}, {half - 0.04f, 0.33f, kEnd - 0.13f});
  m.Box(kSteel, {-half, base, -kEnd}, {half, base + 0.04f, kEnd});
  Cushion(m, Covering(m), {-half + 0.02f, base + 0.04f, -kEnd + 0.02f},
          {half - 0.02f, base + 0.12f, kEnd - 0.02f}, 0.02f);
  if (m.Chance(0.6)) {
    m.Box(kWhiteLinen, {-half, base + 0.07f, -0.5f}, {half, base + 0.135f, kEnd - 0.1f});
  }
  for (const float x : {-half, half}) {
    SideRail(m, kSteel, x, {-0.5f, 0.5f}, {base + 0.04f, base + 0.3f});
  }
}

/// A padded couch along the wall with its head raised, paper drawn over it.
void ExamCouch(PieceMaker& m) {
  const float half = 0.5f * m.Draw(1.8f, 1.95f);
  const float base = m.Draw(0.5f, 0.62f);
  const float deep = m.Draw(0.62f, 0.7f);
  const Surface cover = Covering(m);
  const float head = -half + 0.55f;
  if (m.Chance(0.4)) {
    m.Box(m.palette().cabinet, {-half + 0.05f, 0.05f, 0.04f}, {half - 0.05f, base, deep - 0.04f});
    Drawers(m, m.palette().cabinet,
            {-half + 0.08f, half - 0.08f, 0.08f, base - 0.03f, deep - 0.04f}, 2);
    m.Box(kDark, {-half + 0.1f, 0, 0.08f}, {half - 0.1f, 0.05f, deep - 0.1f});
  } else {
    Legs(m, kSteel,
         {LegStyle::kSquare, {-half + 0.08f, 0.05f}, {half - 0.08f, deep - 0.05f}, base, 0.05f});
    m.Box(kSteel, {-half + 0.06f, base - 0.05f, 0.03f}, {half - 0.06f, base, deep - 0.03f});
  }
  m.RoundedBox(cover, {head, base, 0}, {half, base + 0.1f, deep}, 0.03f);
  m.Box(kPaper, {head + 0.03f, base + 0.1f, 0.08f}, {half - 0.1f, base + 0.108f, deep - 0.08f});
  const Frame frame(&m, Turned({head - 0.01f, base + 0.02f, 0}, 0.0f, 0.0f, -m.Draw(0.3f, 0.6f)));
  m.Box(cover, {-0.5f, 0, 0.0f}, {0, 0.09f, deep});
}

/// A curtain on a frame with feet, between beds.
void BedCurtain(PieceMaker& m) {
  const float half = 0.5f * m.Width(1.4f, 2.0f);
  const float high = m.Draw(1.7f, 1.95f);
  static constexpr std::array<Rgb8, 5> kColors = {Rgb8{176, 208, 220}, Rgb8{190, 216, 190},
                                                  Rgb8{236, 226, 196}, Rgb8{206, 190, 214},
                                                  Rgb8{232, 234, 234}};
  const Surface cloth{"linen", m.rng().Pick(kColors)};
  for (const float x : {-half + 0.02f, half - 0.02f}) {
    Post(m, kChrome, {x, 0.03f, 0}, 0.03f, high - 0.03f);
    m.Box(kChrome, {x - 0.02f, 0, -0.2f}, {x + 0.02f, 0.035f, 0.2f});
  }
  m.Box(kChrome, {-half, high - 0.03f, -0.015f}, {half, high, 0.015f});
  const int folds = std::max(4, static_cast<int>(2.0f * half / 0.14f));
  const float step = (2.0f * half - 0.08f) / static_cast<float>(folds);
  for (int i = 0; i < folds; ++i) {
    const float x = -half + 0.04f + step * static_cast<float>(i);
    const float out = i % 2 == 0 ? 0.012f : -0.012f;
    m.Box(i % 2 == 0 ? cloth : Shaded(cloth, 0.94f), {x, 0.28f, out - 0.018f},
          {x + step, high - 0.03f, out + 0.018f});
  }
}

/// A narrow table on one foot that reaches over a bed.
void OverbedTable(PieceMaker& m) {
  const float high = m.Draw(0.82f, 0.95f);
  m.Box(m.palette().wood, {-0.4f, high - 0.03f, -0.2f}, {0.4f, high, 0.2f});
  m.Box(kSteel, {-0.38f, 0.06f, -0.04f}, {-0.3f, high - 0.03f, 0.04f});
  for (const float z : {-0.18f, 0.14f}) m.Box(kSteel, {-0.38f, 0, z}, {0.3f, 0.06f, z + 0.04f});
  m.Box(kSteel, {-0.38f, 0.02f, -0.18f}, {-0.3f, 0.07f, 0.18f});
  m.AddTop(high, {-0.38f, -0.18f}, {0.38f, 0.18f});
}

/// Sockets, gas and a light over a bed's head.
void BedPanel(PieceMaker& m) {
  const float half = 0.5f * m.Width(1.0f, 1.6f);
  Panel(m, kWhitePlastic, {-half, 0, 0}, {half, 0.28f, 0.07f});
  Panel(m, kGreyPlastic, {-half + 0.03f, 0.05f, 0.07f}, {half - 0.03f, 0.1f, 0.075f});
  for (const float x : Spaced(-half + 0.12f, half - 0.1f, 0.16f)) {
    const Surface socket = m.Chance(0.3) ? Surface{"plastic", BrightColor(m)} : kBlackPlastic;
    Panel(m, socket, {x - 0.03f, 0.13f, 0.07f}, {x + 0.03f, 0.19f, 0.085f});
  }
  m.SetGlow(Glow::kLamp);
  m.Quad({"lamp_shade", {255, 252, 246}}, {-0.7f * half, 0.283f, 0.065f},
         {0.7f * half, 0.283f, 0.065f}, {0.7f * half, 0.283f, 0.02f},
         {-0.7f * half, 0.283f, 0.02f});
  m.SetGlow(Glow::kNone);
}

void OperatingTable(PieceMaker& m) {
  const float high = m.Draw(0.8f, 0.95f);
  const Surface pad = m.Chance(0.7) ? kBlackPlastic : Covering(m);
  m.Block(kSteel, {0, 0, 0}, {0.6f, 0.08f, 1.0f});
  m.Block(kSteel, {0, 0.08f, 0}, {0.3f, high - 0.18f, 0.4f});
  m.Box(kSteel, {-0.26f, high - 0.1f, -1.0f}, {0.26f, high - 0.07f, 1.0f});
  for (const auto& [z0, z1] : {std::pair{-1.0f, -0.68f}, {-0.66f, 0.2f}, {0.22f, 1.0f}}) {
    Cushion(m, pad, {-0.25f, high - 0.07f, z0}, {0.25f, high, z1}, 0.02f);
  }
  if (m.Chance(0.6)) {
    for (const float x : {-0.55f, 0.27f})
      m.Box(pad, {x, high - 0.07f, -0.6f}, {x + 0.28f, high - 0.02f, -0.46f});
  }
}

/// A dish of lights on an arm.
void SurgicalLamp(PieceMaker& m) {
  const float drop = m.Draw(0.45f, 0.6f);
  const float out = m.Draw(0.15f, 0.3f);
  m.Cylinder(kWhitePlastic, {0, -0.06f, 0}, 0.12f, 0.06f, 8);
  m.Bar(kWhitePlastic, {0, -0.06f, 0}, {0, -0.3f, 0}, 0.035f, 6);
  m.Bar(kWhitePlastic, {0, -0.3f, 0}, {out, -drop, 0}, 0.03f, 6);
  m.Turn(kWhitePlastic, {out, -drop - 0.12f, 0},
         {{0.3f, 0.0f}, {0.28f, 0.06f}, {0.1f, 0.12f}, {0.0f, 0.13f}}, 12);
  m.SetGlow(Glow::kLamp);
  m.Turn({"lamp_shade", {255, 252, 246}}, {out, -drop - 0.12f, 0}, {{0.0f, 0.0f}, {0.29f, 0.0f}},
         12);
  m.SetGlow(Glow::kNone);
}

constexpr std::array kKinds = {
    FurnitureKind{"bed_curtain", Placement::kFree, 0.0f, BedCurtain, 1.0f, 2.2f},
    FurnitureKind{"bed_panel", Placement::kOnWall, 0.0f, BedPanel, 0.9f, 2.4f},
    FurnitureKind{"exam_couch", Placement::kAgainstWall, 0.6f, ExamCouch},
    FurnitureKind{"gurney", Placement::kFree, 0.1f, Gurney},
    FurnitureKind{"hospital_bed", Placement::kAgainstWall, 0.6f, HospitalBed},
    FurnitureKind{"operating_table", Placement::kFree, 0.7f, OperatingTable},
    FurnitureKind{"overbed_table", Placement::kFree, 0.0f, OverbedTable},
    FurnitureKind{"surgical_lamp", Placement::kCeiling, 0.0f, SurgicalLamp}};

}  // namespace

std::span<const FurnitureKind> ClinicBeds() {
  return kKinds;
}

}  // namespace bulletnav::sim::furniture
