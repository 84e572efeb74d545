// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "sim/base/elementary.h"
#include "sim/house/furniture/parts.h"

namespace bulletnav::sim::furniture {
namespace {

/// Books side by side as one block: spines on the front, paper on top.
void BookBlock(PieceMaker& m, const Vec& low, const Vec& high) {
  const Surface spines{m.Chance(0.7) ? "book_spines" : "book_spines_dark"};
  const float start = m.Draw(0.0f, 1.0f);
  const float end = start + (high.x() - low.x());
  const auto at = [&](int x, int y, int z) {
    return Vec(x ? high.x() : low.x(), y ? high.y() : low.y(), z ? high.z() : low.z());
  };
  m.Picture(spines, at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1),
            {Vec2(start, 0.0f), Vec2(end, 1.0f)});
  const Surface cover{"paper", MutedColor(m)};
  m.Quad(cover, at(1, 0, 1), at(1, 0, 0), at(1, 1, 0), at(1, 1, 1));
  m.Quad(cover, at(0, 0, 0), at(0, 0, 1), at(0, 1, 1), at(0, 1, 0));
  m.Quad(kPaper, at(0, 1, 1), at(1, 1, 1), at(1, 1, 0), at(0, 1, 0));
}

void LyingBooks(PieceMaker& m, const Vec& at, const Vec& size) {
  float y = at.y();
  const int count = std::min(m.Between(2, 4), static_cast<int>(size.y() / 0.04f));
  for (int i = 0; i < count; ++i) {
    const float x = 0.5f * std::min(size.x(), 0.26f) * m.Draw(0.8f, 1.0f);
    const float z = 0.5f * std::min(size.z(), 0.19f) * m.Draw(0.8f, 1.0f);
    Panel(m, {"paper", MutedColor(m)}, {at.x() - x, y, at.z() - z},
          {at.x() + x, y + 0.038f, at.z() + z});
    y += 0.038f;
  }
}

void SmallPlant(PieceMaker& m, const Vec& at, float radius, float height) {
  m.Cone({"ceramic", MutedColor(m)}, at, 0.4f * radius, 0.55f * radius, 0.4f * height, 6);
  const Vec top = at + Vec(0, 0.4f * height, 0);
  for (int i = 0; i < 7; ++i) {
    const float angle = 0.9f * static_cast<float>(i);
    const Vec along(0.8f * radius * Cos(angle), 0.5f * height, 0.8f * radius * Sin(angle));
    Leaf(m, kLeaves, top, along, 0.6f * radius);
  }
}

}  // namespace

void Leaf(PieceMaker& m, const Surface& surface, const Vec& base, const Vec& along, float width) {
  const Vec level = std::abs(along.normalized().y()) < 0.98f ? Vec::UnitY() : Vec::UnitX();
  const Vec side = 0.5f * width * along.cross(level).normalized();
  const Vec middle = base + 0.45f * along + Vec(0, 0.08f * along.norm(), 0);
  const Vec tip = base + along;
  m.Triangle(surface, base, middle + side, tip);
  m.Triangle(surface, base, tip, middle - side);
}

void Books(PieceMaker& m, const Vec& low, const Vec& high) {
  const float tallest = std::min(0.32f, 0.95f * (high.y() - low.y()));
  float x = low.x();
  const float end = m.Chance(0.4) ? high.x() - 0.25f * (high.x() - low.x()) : high.x();
  while (x < end - 0.05f) {
    const float width = std::min(m.Draw(0.14f, 0.34f), end - x);
    const float top = low.y() + tallest * m.Draw(0.7f, 1.0f);
    BookBlock(m, {x, low.y(), low.z()}, {x + width, top, high.z() - m.Draw(0.02f, 0.06f)});
    x += width;
  }
}

void Ornament(PieceMaker& m, const Vec& at, const Vec& size) {
  const float radius = 0.5f * std::min({size.x(), size.z(), 0.3f});
  const float height = std::min(size.y(), 0.34f) * m.Draw(0.6f, 0.95f);
  const Surface color{"ceramic", MutedColor(m)};
  switch (m.Below(6)) {
    case 0:  // vase
      m.Turn(color, at,
             {{0.45f * radius, 0.0f},
              {0.8f * radius, 0.4f * height},
              {0.3f * radius, 0.8f * height},
              {0.42f * radius, height}},
             8);
      break;
    case 1:  // box
      m.Block(m.Chance(0.5) ? kWicker : Surface{"cardboard", MutedColor(m)}, at,
              {1.7f * radius, 0.7f * height, 1.5f * radius});
      break;
    case 2:  // bowl
      m.Turn(color, at,
             {{0.4f * radius, 0.0f},
              {0.95f * radius, 0.35f * height},
              {0.85f * radius, 0.35f * height},
              {0.0f, 0.1f * height}},
             8);
      break;
    case 3:
      SmallPlant(m, at, radius, height);
      break;
    case 4: {  // framed photograph
      const Frame frame(&m, Turned(at - Vec(0, 0, 0.3f * radius), 0.0f, -0.2f));
      Panel(m, m.palette().other_wood, {-0.8f * radius, 0, -0.01f},
            {0.8f * radius, 0.9f * height, 0.01f});
      FamilyPhoto(m, {0, 0.1f * height, 0.013f}, 1.2f * radius, 0.7f * height);
      break;
    }
    case 5:
      LyingBooks(m, at, size);
      break;
  }
}

}  // namespace bulletnav::sim::furniture
