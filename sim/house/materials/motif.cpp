// SPDX-License-Identifier: MIT
#include "sim/house/materials/motif.h"

#include "sim/base/elementary.h"

namespace bulletnav::sim::materials {

void PaintFlower(Canvas* canvas, Point centre, float radius, float angle, const FlowerLook& look) {
  const float n = static_cast<float>(look.petals);
  for (int i = 0; i < look.petals; ++i) {
    const float turn = angle + 2.0f * kPi * static_cast<float>(i) / n;
    const Point middle = centre + Turned({0.0f, -0.56f * radius}, turn);
    const Ellipse petal = {middle, {std::min(0.4f, 1.9f / n) * radius, 0.45f * radius}, turn};
    // Petals darken towards the heart, and each is a little different from the next.
    const float tone = i % 2 == 0 ? 1.0f : 0.95f;
    canvas->Paint(petal, [&](Point p) {
      return look.petal * (tone * Mix(0.84f, 1.03f, Clamp01(Length(p - centre) / radius)));
    });
  }
  canvas->Paint(Disc(centre, 0.25f * radius), look.heart);
}

void PaintFrond(Canvas* canvas, Point root, Point tip, int pairs, Color color) {
  const Point along = tip - root;
  const float length = Length(along);
  canvas->Paint(Stroke{root, tip, 0.025f * length}, color);
  for (int i = 0; i < pairs; ++i) {
    const float t = (static_cast<float>(i) + 0.6f) / static_cast<float>(pairs);
    const Point from = root + along * t;
    const float reach = 0.42f * Sin(kPi * Mix(0.22f, 0.95f, t));
    for (const float side : {-1.0f, 1.0f}) {
      const Point leaflet = Turned(along * reach, side * Mix(0.95f, 0.5f, t));
      canvas->Paint(Leaf{from, from + leaflet, 0.24f * Length(leaflet)}, color);
    }
  }
  canvas->Paint(Leaf{root + along * 0.86f, root + along * 1.12f, 0.07f * length}, color);
}

void PaintDamask(Canvas* canvas, Point centre, float height, Color color) {
  const auto at = [&](float x, float y) {
    return centre + Point{x, y} * height;
  };
  const auto leaf = [&](Point from, Point to, float width) {
    for (const float side : {-1.0f, 1.0f}) {
      canvas->Paint(Leaf{at(side * from.x, from.y), at(side * to.x, to.y), width * height}, color);
    }
  };
  const auto ring = [&](Point middle, float radius) {
    for (const float side : {-1.0f, 1.0f}) {
      const Ring scroll = {at(side * middle.x, middle.y), radius * height, 0.42f * radius * height};
      canvas->Paint(scroll, color);
    }
  };
  // On the axis: crown, heart and root.
  leaf({0.0f, -0.5f}, {0.0f, -0.25f}, 0.11f);
  leaf({0.0f, -0.17f}, {0.0f, 0.17f}, 0.16f);
  leaf({0.0f, 0.27f}, {0.0f, 0.5f}, 0.09f);
  // Plumes beside the crown.
  leaf({0.02f, -0.24f}, {0.12f, -0.43f}, 0.075f);
  leaf({0.03f, -0.22f}, {0.22f, -0.34f}, 0.075f);
  ring({0.25f, -0.27f}, 0.04f);
  // Wings around the heart.
  leaf({0.11f, -0.17f}, {0.27f, -0.16f}, 0.07f);
  leaf({0.12f, -0.12f}, {0.36f, -0.02f}, 0.09f);
  leaf({0.12f, 0.0f}, {0.33f, 0.07f}, 0.08f);
  leaf({0.1f, 0.08f}, {0.26f, 0.14f}, 0.07f);
  ring({0.12f, -0.07f}, 0.045f);
  // Cup and scrolls below.
  leaf({0.02f, 0.26f}, {0.2f, 0.19f}, 0.085f);
  leaf({0.02f, 0.29f}, {0.23f, 0.28f}, 0.07f);
  leaf({0.02f, 0.31f}, {0.15f, 0.4f}, 0.065f);
  ring({0.25f, 0.23f}, 0.035f);
}

}  // namespace bulletnav::sim::materials
