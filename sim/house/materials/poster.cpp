// SPDX-License-Identifier: MIT
// Posters and photographs. Shown once.
#include "sim/base/elementary.h"
#include "sim/house/materials/brushwork.h"
#include "sim/house/materials/families.h"
#include "sim/house/materials/field.h"
#include "sim/house/materials/noise.h"

namespace bulletnav::sim::materials {
namespace {

void PaintElephant(Canvas* canvas, Point p, float s) {
  const Color skin = Hex(0x8fa3b5);
  const auto ellipse = [&](Point at, Point radii, Color color) {
    canvas->Paint(Ellipse{p + at * s, radii * s}, color);
  };
  for (const float x : {-0.3f, -0.08f, 0.14f}) {
    canvas->Paint(Rect{p + Point{x, 0.1f} * s, p + Point{x + 0.16f, 0.55f} * s, 0.05f * s},
                  skin * 0.93f);
  }
  ellipse({-0.08f, 0.05f}, {0.38f, 0.29f}, skin);
  ellipse({0.32f, -0.12f}, {0.21f, 0.2f}, skin * 1.04f);
  ellipse({0.17f, -0.12f}, {0.15f, 0.19f}, Hex(0xa9bac8));
  canvas->Paint(Stroke{p + Point{0.46f, -0.05f} * s, p + Point{0.52f, 0.3f} * s, 0.11f * s},
                skin * 1.04f);
  canvas->Paint(Stroke{p + Point{0.52f, 0.3f} * s, p + Point{0.62f, 0.33f} * s, 0.09f * s},
                skin * 1.04f);
  canvas->Paint(Disc(p + Point{0.38f, -0.17f} * s, 0.028f * s), Hex(0x2f3640));
}

void PaintLion(Canvas* canvas, Point p, float s) {
  const Color mane = Hex(0xb9652c);
  for (int i = 0; i < 12; ++i) {
    canvas->Paint(
        Disc(p + Turned({0.34f * s, 0.0f}, kPi * static_cast<float>(i) / 6.0f), 0.14f * s), mane);
  }
  canvas->Paint(Disc(p, 0.36f * s), Hex(0xf0b857));
  canvas->Paint(Ellipse{p + Point{0.0f, 0.14f} * s, {0.17f * s, 0.13f * s}}, Hex(0xfbe3b4));
  canvas->Paint(Leaf{p + Point{-0.08f, 0.06f} * s, p + Point{0.08f, 0.06f} * s, 0.07f * s},
                Hex(0x5a3522));
  for (const float side : {-1.0f, 1.0f}) {
    canvas->Paint(Disc(p + Point{0.14f * side, -0.08f} * s, 0.04f * s), Hex(0x40291c));
  }
}

void PaintWhale(Canvas* canvas, Point p, float s) {
  const Color skin = Hex(0x3f7cac);
  canvas->Paint(Ellipse{p, {0.46f * s, 0.27f * s}}, skin);
  canvas->Paint(Ellipse{p + Point{-0.04f, 0.11f} * s, {0.36f * s, 0.14f * s}}, Hex(0xdceaf2));
  canvas->Paint(Leaf{p + Point{0.4f, -0.02f} * s, p + Point{0.72f, -0.3f} * s, 0.15f * s}, skin);
  canvas->Paint(Leaf{p + Point{0.4f, -0.02f} * s, p + Point{0.76f, -0.04f} * s, 0.13f * s}, skin);
  canvas->Paint(Disc(p + Point{-0.28f, -0.04f} * s, 0.03f * s), Hex(0x16283a));
  for (const float side : {-1.0f, 1.0f}) {
    canvas->Paint(Stroke{p + Point{-0.1f, -0.28f} * s, p + Point{-0.1f + 0.12f * side, -0.5f} * s,
                         0.035f * s},
                  Hex(0x8cc4e6));
  }
}

void PaintGiraffe(Canvas* canvas, Point p, float s) {
  const Color coat = Hex(0xf0c060);
  canvas->Paint(Polygon{p + Point{-0.14f, 0.6f} * s, p + Point{-0.02f, -0.3f} * s,
                        p + Point{0.14f, -0.3f} * s, p + Point{0.2f, 0.6f} * s},
                coat);
  canvas->Paint(Ellipse{p + Point{0.1f, -0.38f} * s, {0.2f * s, 0.13f * s}, 0.2f}, coat);
  for (const float x : {0.0f, 0.1f}) {
    canvas->Paint(Stroke{p + Point{x, -0.48f} * s, p + Point{x - 0.02f, -0.62f} * s, 0.035f * s},
                  Hex(0x8c5a2e));
  }
  constexpr Point kSpots[] = {{0.02f, -0.14f}, {0.1f, 0.0f},   {0.0f, 0.16f},
                              {0.12f, 0.26f},  {-0.04f, 0.4f}, {0.12f, 0.48f}};
  for (const Point& spot : kSpots) canvas->Paint(Disc(p + spot * s, 0.05f * s), Hex(0xb9783a));
  canvas->Paint(Disc(p + Point{0.12f, -0.41f} * s, 0.026f * s), Hex(0x3a2818));
}

/// Four animals on four coloured fields.
Image Animals() {
  Canvas canvas(Hex(0xfaf5e8), Edge::kClip);
  constexpr Color kFields[] = {Hex(0xf6c9b8), Hex(0xc4e0d0), Hex(0xd3e3f3), Hex(0xf7e3a8)};
  for (int i = 0; i < 4; ++i) {
    const Point low = Point{0.05f, 0.05f} + CellOf(i, 2) * 0.46f;
    canvas.Paint(Rect{low, low + Point{0.44f, 0.44f}, 0.03f}, kFields[i]);
  }
  PaintElephant(&canvas, {0.25f, 0.24f}, 0.32f);
  PaintLion(&canvas, {0.73f, 0.27f}, 0.36f);
  PaintWhale(&canvas, {0.24f, 0.76f}, 0.3f);
  PaintGiraffe(&canvas, {0.72f, 0.74f}, 0.32f);
  return canvas.Finish();
}

void PaintPlanet(Canvas* canvas, Point centre, float radius, Color light, Color dark) {
  canvas->Paint(Disc(centre, radius), [&](Point p) {
    const Point d = (p - centre) * (1.0f / radius);
    const float bands = 0.5f + 0.5f * Sin(9.0f * d.y + 1.2f * d.x);
    return Mix(light, dark, 0.5f * bands) *
           (1.05f - 0.5f * Smooth(-0.3f, 1.1f, 0.7f * (d.x + d.y)));
  });
}

void PaintRocket(Canvas* canvas, Point p, float s) {
  const float tilt = 0.5f;
  const auto at = [&](float x, float y) {
    return p + Turned(Point{x, y} * s, tilt);
  };
  canvas->Paint(Leaf{at(0.0f, 0.28f), at(0.0f, 0.75f), 0.18f * s}, Hex(0xf59a3a));
  canvas->Paint(Leaf{at(0.0f, 0.28f), at(0.0f, 0.58f), 0.1f * s}, Hex(0xfbe27a));
  for (const float side : {-1.0f, 1.0f}) {
    canvas->Paint(Polygon{at(0.1f * side, 0.05f), at(0.3f * side, 0.4f), at(0.1f * side, 0.3f)},
                  Hex(0xd9483f));
  }
  canvas->Paint(Leaf{at(0.0f, -0.62f), at(0.0f, 0.52f), 0.36f * s}, Hex(0xf4f2ec));
  canvas->Paint(Rect{at(0.0f, 0.3f) - Point{0.11f, 0.06f} * s,
                     at(0.0f, 0.3f) + Point{0.11f, 0.06f} * s, 0.0f, tilt},
                Hex(0x7c8794));
  canvas->Paint(Polygon{at(0.0f, -0.62f), at(0.115f, -0.34f), at(-0.115f, -0.34f)}, Hex(0xd9483f));
  canvas->Paint(Disc(at(0.0f, -0.12f), 0.1f * s), Hex(0x7c8794));
  canvas->Paint(Disc(at(0.0f, -0.12f), 0.072f * s), Hex(0x8fd0ee));
}

Image Space() {
  Canvas canvas(Color{}, Edge::kClip);
  const Field nebula(64, 64, [](Point p) {
    return Fbm(p, {2, 3, 1}, 4);
  });
  canvas.Shade([&](Point p) {
    const Color night = Mix(Hex(0x1d2450), Hex(0x2f3a7c), p.y);
    return Mix(night, Hex(0x7a4f9e), 0.6f * Smooth(0.0f, 1.0f, nebula(p)));
  });
  Rng rng(0, "poster_space");
  for (int i = 0; i < 110; ++i) {
    const Point at = Anywhere(rng);
    const float radius = Between(rng, 0.002f, 0.006f);
    canvas.Paint(Disc(at, radius), Hex(0xf6f3dc), {Between(rng, 0.5f, 1.0f), 0.0f});
  }
  for (int i = 0; i < 7; ++i) canvas.Paint(Star(Anywhere(rng), 4, {0.006f, 0.026f}), Hex(0xfff3b8));
  PaintPlanet(&canvas, {0.25f, 0.27f}, 0.15f, Hex(0xf2c27a), Hex(0xb9743f));
  canvas.Paint(Ellipse{{0.25f, 0.27f}, {0.25f, 0.035f}, -0.35f}, Hex(0xf6e3b4), {0.55f, 0.0f});
  PaintPlanet(&canvas, {0.25f, 0.245f}, 0.12f, Hex(0xf2c27a), Hex(0xb9743f));
  PaintPlanet(&canvas, {0.82f, 0.17f}, 0.08f, Hex(0xe88a78), Hex(0xa04a4a));
  PaintPlanet(&canvas, {0.2f, 0.95f}, 0.24f, Hex(0x7fd0c0), Hex(0x3a7fa0));
  PaintRocket(&canvas, {0.62f, 0.58f}, 0.42f);
  return canvas.Finish();
}

struct Sitter {
  Color skin;
  Color hair;
  Color clothes;
  bool long_hair = false;
};

/// Head and shoulders, `s` wide.
void PaintPerson(Canvas* canvas, Point neck, float s, const Sitter& who) {
  canvas->Paint(Ellipse{neck + Point{0.0f, 0.5f} * s, {0.5f * s, 0.46f * s}}, who.clothes);
  if (who.long_hair)
    canvas->Paint(Ellipse{neck + Point{0.0f, -0.2f} * s, {0.27f * s, 0.36f * s}}, who.hair);
  canvas->Paint(Rect{neck + Point{-0.08f, -0.1f} * s, neck + Point{0.08f, 0.12f} * s},
                who.skin * 0.88f);
  canvas->Paint(Ellipse{neck + Point{0.0f, -0.33f} * s, {0.225f * s, 0.26f * s}}, who.hair);
  canvas->Paint(Ellipse{neck + Point{0.0f, -0.25f} * s, {0.19f * s, 0.24f * s}}, who.skin);
  for (const float side : {-1.0f, 1.0f}) {
    canvas->Paint(Disc(neck + Point{0.075f * side, -0.28f} * s, 0.025f * s), Hex(0x33261f));
  }
  canvas->Paint(Leaf{neck + Point{-0.08f, -0.14f} * s, neck + Point{0.08f, -0.14f} * s, 0.05f * s},
                Hex(0xb4605a));
}

/// Nine framed photographs of a family on a pale wall of passe-partout.
Image FamilyPhotos() {
  Canvas canvas(Hex(0xf4f1ea), Edge::kClip);
  constexpr Color kSkins[] = {Hex(0xf0c8a4), Hex(0xe0ad85), Hex(0xc88e66), Hex(0xf3d2b4)};
  constexpr Color kHairs[] = {Hex(0x3b2a20), Hex(0x8a5a34), Hex(0xd8b26a), Hex(0xb9b4ae),
                              Hex(0x221c1a)};
  constexpr Color kClothes[] = {Hex(0xc95548), Hex(0x4a7db0), Hex(0xf2efe8), Hex(0x5d8a66),
                                Hex(0xe2b557), Hex(0x6f5a8c), Hex(0x39414d)};
  constexpr Color kGrounds[] = {Hex(0xa9cde6), Hex(0x9fc58a), Hex(0xd9cbb4), Hex(0x8f9fae),
                                Hex(0xe6d6c8)};
  constexpr int kAcross = 3;
  Rng rng(0, "family_photos");
  for (int i = 0; i < kAcross * kAcross; ++i) {
    const Point centre = (CellOf(i, kAcross) + Point{0.5f, 0.5f}) * (1.0f / kAcross);
    const Point half = {0.142f, 0.142f};
    canvas.Paint(Rect{centre - half, centre + half}, i % 2 == 0 ? Hex(0x33302d) : Hex(0x8c6642));
    canvas.Paint(Rect{centre - half * 0.86f, centre + half * 0.86f}, Hex(0xfaf8f2));
    const Point inside = half * 0.7f;
    Canvas photo(OneOf(rng, kGrounds), Edge::kClip, 64);
    photo.Shade([&](Point p, Color c) {
      return p.y > 0.7f ? Mix(c, Hex(0x7fa060), 0.7f) : c * Mix(1.1f, 0.95f, p.y);
    });
    const int people = i % 3 == 0 ? 1 : i % 3 == 1 ? 2 : 3;
    for (int k = 0; k < people; ++k) {
      const float x = (static_cast<float>(k) + 0.5f) / static_cast<float>(people);
      const float size = people == 1 ? 0.75f : people == 2 ? 0.58f : 0.44f * (k == 1 ? 0.8f : 1.0f);
      PaintPerson(&photo, {Mix(0.5f, x, 0.85f), k == 1 && people == 3 ? 0.78f : 0.68f}, size,
                  {OneOf(rng, kSkins), OneOf(rng, kHairs), OneOf(rng, kClothes), rng.Chance(0.5)});
    }
    canvas.Paint(Rect{centre - inside, centre + inside}, [&](Point p) {
      const Point q = p - centre + inside;
      return photo.At({q.x / (2.0f * inside.x), q.y / (2.0f * inside.y)});
    });
  }
  return canvas.Finish();
}

constexpr MaterialRecipe kRecipes[] = {
    {"family_photos", MaterialFamily::kOther, 1.0f, FamilyPhotos, false},
    {"poster_animals", MaterialFamily::kOther, 1.0f, Animals, false},
    {"poster_space", MaterialFamily::kOther, 1.0f, Space, false},
};

}  // namespace

std::span<const MaterialRecipe> Posters() {
  return kRecipes;
}

}  // namespace bulletnav::sim::materials
