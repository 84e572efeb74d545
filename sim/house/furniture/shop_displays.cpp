// SPDX-License-Identifier: MIT
// What shops show their goods on.
#include <algorithm>
#include <array>
#include <cmath>

#include "sim/house/furniture/families.h"
#include "sim/house/furniture/parts.h"

namespace bulletnav::sim::furniture {
namespace {

enum class Goods { kPackets, kBottles, kBoxes, kBooks };

/// A picture of goods on the front of a block that fills `low` to `high`.
void PicturedRow(PieceMaker& m, const Surface& picture, const Vec& low, const Vec& high) {
  const float z = high.z() - 0.02f;
  Panel(m, kPaper, low, {high.x(), high.y(), z - 0.005f});
  m.Picture(picture, {low.x(), low.y(), z}, {high.x(), low.y(), z}, {high.x(), high.y(), z},
            {low.x(), high.y(), z}, {Vec2(0, 0), Vec2(high.x() - low.x(), 1.0f)});
}

/// One shelf's goods between two corners, seen from +z.
void GoodsRow(PieceMaker& m, Goods goods, const Vec& low, const Vec& high) {
  if (m.Chance(0.08)) return;  // sold out
  const float top = low.y() + m.Draw(0.65f, 0.92f) * (high.y() - low.y());
  const Vec upper(high.x(), top, high.z());
  switch (goods) {
    case Goods::kPackets:
      return PicturedRow(m, {"food_boxes"}, low, upper);
    case Goods::kBottles:
      return PicturedRow(m, {"bottles"}, low, upper);
    case Goods::kBooks:
      return Books(m, low, high);
    case Goods::kBoxes:
      break;
  }
  const float width = high.x() - low.x();
  const auto count = std::max(1, static_cast<int>(width / 0.45f));
  const float share = width / static_cast<float>(count);
  for (int i = 0; i < count; ++i) {
    const float x = low.x() + share * static_cast<float>(i);
    const Surface box{"plastic", m.Chance(0.5) ? MutedColor(m) : BrightColor(m)};
    const float tall = low.y() + m.Draw(0.5f, 0.9f) * (high.y() - low.y());
    Panel(m, box, {x + 0.02f, low.y(), low.z()}, {x + 0.9f * share, tall, high.z() - 0.03f});
  }
}

struct Rack {
  float half = 0.6f;
  float high = 1.6f;
  float deep = 0.4f;  // from the middle to one side's front
  int rows = 4;
};

/// Shelves on one side of a board at z = 0, which looks to +z.
void ShelfSide(PieceMaker& m, const Surface& steel, const Rack& rack, Goods goods) {
  const float pitch = (rack.high - 0.1f) / static_cast<float>(rack.rows);
  for (int r = 0; r < rack.rows; ++r) {
    const float y = 0.1f + pitch * static_cast<float>(r);
    const float deep = r == 0 ? rack.deep : 0.85f * rack.deep;
    m.Box(steel, {-rack.half, r == 0 ? 0.0f : y - 0.03f, 0.02f}, {rack.half, y, deep});
    GoodsRow(m, goods, {-rack.half + 0.02f, y, 0.03f},
             {rack.half - 0.02f, y + pitch - 0.04f, deep - 0.01f});
  }
}

Surface RackSurface(PieceMaker& m) {
  const std::array kinds = {kWhitePaint, Surface{"painted_wood", {120, 124, 128}}, m.palette().wood,
                            m.palette().cabinet};
  return m.rng().Pick(kinds);
}

void BothSides(PieceMaker& m, const Rack& rack, std::span<const Goods> goods) {
  const Surface steel = RackSurface(m);
  m.Box(steel, {-rack.half, 0, -0.02f}, {rack.half, rack.high, 0.02f});
  for (const float yaw : {0.0f, 2.0f * kQuarterTurn}) {
    const Frame frame(&m, {0, 0, 0}, yaw);
    ShelfSide(m, steel, rack, m.rng().Pick(goods));
  }
}

/// Shelves along an aisle, full of goods on both sides.
void Gondola(PieceMaker& m) {
  static constexpr std::array kGoods = {Goods::kPackets, Goods::kPackets, Goods::kBottles,
                                        Goods::kBoxes};
  Rack rack;
  rack.half = 0.5f * m.Width(1.2f, 2.4f);
  rack.high = m.Draw(1.3f, 1.9f);
  rack.deep = m.Draw(0.38f, 0.5f);
  rack.rows = m.Between(3, 5);
  BothSides(m, rack, kGoods);
}

/// The same with books.
void BookGondola(PieceMaker& m) {
  static constexpr std::array kGoods = {Goods::kBooks};
  Rack rack;
  rack.half = 0.5f * m.Width(1.0f, 2.0f);
  rack.high = m.Draw(1.2f, 1.75f);
  rack.deep = m.Draw(0.3f, 0.36f);
  rack.rows = m.Between(3, 4);
  BothSides(m, rack, kGoods);
}

/// A stack of books or of folded clothes.
void Stack(PieceMaker& m, const Vec& at, const Vec2& foot) {
  const bool is_cloth = m.Chance(0.4);
  const int layers = m.Between(1, 4);
  float y = at.y();
  for (int i = 0; i < layers; ++i) {
    const float thick = is_cloth ? 0.035f : m.Draw(0.02f, 0.05f);
    const Surface thing{is_cloth ? "linen" : "cardboard",
                        m.Chance(0.3) ? BrightColor(m) : MutedColor(m)};
    m.Box(thing, {at.x() - 0.5f * foot.x(), y, at.z() - 0.5f * foot.y()},
          {at.x() + 0.5f * foot.x(), y + thick, at.z() + 0.5f * foot.y()});
    y += thick;
  }
}

/// A table with stacks of goods to walk around.
void GoodsTable(PieceMaker& m) {
  const float half = 0.5f * m.Width(1.1f, 2.0f);
  const float deep = 0.5f * m.Draw(0.75f, 1.15f);
  const float high = m.Draw(0.72f, 0.88f);
  const Surface top = RackSurface(m);
  m.Box(top, {-half, high - 0.05f, -deep}, {half, high, deep});
  if (m.Chance(0.4)) {
    m.Box(Shaded(top, 0.85f), {-half + 0.06f, 0, -deep + 0.06f},
          {half - 0.06f, high - 0.05f, deep - 0.06f});
  } else {
    Legs(m, top, {LegStyle::kSquare, {-half, -deep}, {half, deep}, high - 0.05f, 0.06f});
  }
  for (const float x : Spaced(-half + 0.18f, half - 0.12f, 0.36f)) {
    for (const float z : Spaced(-deep + 0.2f, deep - 0.12f, 0.38f)) {
      if (m.Chance(0.85)) Stack(m, {x, high, z}, m.Draw(Vec2(0.16f, 0.2f), Vec2(0.28f, 0.3f)));
    }
  }
}

/// Clothes on a rail in the open, seen from both sides.
void GarmentRack(PieceMaker& m) {
  const float half = 0.5f * m.Width(1.0f, 1.8f, 0.04f);
  const float high = m.Draw(1.35f, 1.6f);
  const Surface& metal = m.palette().metal;
  for (const float x : {-half, half}) {
    m.Bar(metal, {x, 0.03f, 0}, {x, high, 0}, 0.018f);
    m.Box(metal, {x - 0.02f, 0, -0.25f}, {x + 0.02f, 0.035f, 0.25f});
  }
  m.Bar(metal, {-half, high, 0}, {half, high, 0}, 0.015f);
  for (const float x : Spaced(-half + 0.08f, half - 0.04f, 0.09f)) {
    if (m.Chance(0.12)) continue;
    const float low = high - m.Draw(0.65f, 1.05f);
    const Surface cloth{m.Chance(0.5) ? "linen" : "wool_knit",
                        m.Chance(0.3) ? BrightColor(m) : MutedColor(m)};
    const float wide = m.Draw(0.19f, 0.24f);
    m.TaperedBox(cloth, {x, low, 0}, {0.06f, 2.0f * wide}, {x, high - 0.05f, 0}, {0.03f, 0.3f});
  }
}

/// A dressed figure on a stand.
void Mannequin(PieceMaker& m) {
  const Surface skin = m.Chance(0.5) ? kWhitePlastic : Surface{"plastic", {70, 68, 66}};
  const Surface coat{"linen", MutedColor(m)};
  const Surface trousers{"canvas", MutedColor(m)};
  const float high = m.Draw(1.62f, 1.8f);
  m.Cylinder(kSteel, {0, 0, 0}, 0.2f, 0.02f);
  for (const float x : {-0.09f, 0.09f}) {
    m.Cone(trousers, {x, 0.02f, 0}, 0.055f, 0.085f, 0.5f * high, 8);
  }
  m.Loft(coat, std::array{MeshBuilder::Oval{{0, 0.46f * high, 0}, {0.19f, 0.12f}},
                          MeshBuilder::Oval{{0, 0.62f * high, 0}, {0.15f, 0.1f}},
                          MeshBuilder::Oval{{0, 0.8f * high, 0}, {0.22f, 0.12f}},
                          MeshBuilder::Oval{{0, 0.84f * high, 0}, {0.0f, 0.0f}}});
  for (const float side : {-1.0f, 1.0f}) {
    const float out = m.Draw(0.24f, 0.32f);
    m.Bar(coat, {0.2f * side, 0.79f * high, 0}, {out * side, 0.48f * high, 0.05f}, 0.05f);
    m.Ball(skin, {out * side, 0.45f * high, 0.06f}, {0.04f, 0.06f, 0.04f}, 6);
  }
  m.Cylinder(skin, {0, 0.82f * high, 0}, 0.05f, 0.08f * high, 8);
  m.Ball(skin, {0, 0.935f * high, 0}, {0.08f, 0.065f * high, 0.095f});
}

/// A cold shelf with a lit inside, open or behind glass doors.
void ShopCooler(PieceMaker& m) {
  const float width = m.Width(1.2f, 2.4f);
  const float half = 0.5f * width;
  const float high = m.Draw(1.8f, 2.05f);
  constexpr float kDeep = 0.72f;
  const Surface body = m.Chance(0.5) ? kWhitePlastic : kGreyPlastic;
  const Goods goods = m.Chance(0.5) ? Goods::kBottles : Goods::kPackets;
  m.Box(body, {-half, 0, 0}, {half, high, 0.1f});
  m.Box(body, {-half, 0, 0.1f}, {half, 0.3f, kDeep});
  m.Box(body, {-half, high - 0.2f, 0.1f}, {half, high, kDeep});
  for (const float x : {-half, half - 0.04f}) {
    m.Box(body, {x, 0.3f, 0.1f}, {x + 0.04f, high - 0.2f, kDeep});
  }
  constexpr int kRows = 4;
  const float pitch = (high - 0.5f) / static_cast<float>(kRows);
  for (int r = 0; r < kRows; ++r) {
    const float y = 0.3f + pitch * static_cast<float>(r);
    if (r > 0) m.Box(kSteel, {-half + 0.04f, y - 0.02f, 0.1f}, {half - 0.04f, y, 0.6f});
    GoodsRow(m, goods, {-half + 0.06f, y, 0.1f}, {half - 0.06f, y + pitch - 0.05f, 0.58f});
  }
  const Surface band{"plastic", BrightColor(m)};
  Panel(m, band, {-half, high - 0.17f, kDeep}, {half, high - 0.03f, kDeep + 0.015f});
}

constexpr std::array kKinds = {
    FurnitureKind{"book_gondola", Placement::kFree, 0.5f, BookGondola, 0.9f, 2.4f},
    FurnitureKind{"garment_rack", Placement::kFree, 0.4f, GarmentRack, 0.9f, 2.2f},
    FurnitureKind{"gondola", Placement::kFree, 0.5f, Gondola, 0.9f, 2.6f},
    FurnitureKind{"goods_table", Placement::kFree, 0.5f, GoodsTable, 0.9f, 2.4f},
    FurnitureKind{"mannequin", Placement::kFree, 0.2f, Mannequin},
    FurnitureKind{"shop_cooler", Placement::kAgainstWall, 0.8f, ShopCooler, 1.0f, 3.0f}};

}  // namespace

std::span<const FurnitureKind> ShopDisplays() {
  return kKinds;
}

}  // namespace bulletnav::sim::furniture
