// SPDX-License-Identifier: MIT
// What is seen out of windows: bright, as daylight is. Shown once.
#include "sim/house/materials/families.h"
#include "sim/house/materials/motif.h"
#include "sim/house/materials/noise.h"
#include "sim/house/materials/scenery.h"

namespace bulletnav::sim::materials {
namespace {

constexpr Color kZenith = Hex(0xa4cdf2);
constexpr Color kHorizon = Hex(0xeef5fa);
constexpr Color kGrass = Hex(0x9ccb70);

/// Lawn, fence, hedge and trees under a summer sky.
Image Garden() {
  Canvas canvas(Color{}, Edge::kClip);
  const Sky sky(kZenith, kHorizon, 0.6f, 0.4f);
  const Ridge trees(0.5f, 0.16f, 5);
  const Field lawn(128, 128, [](Point p) {
    return Noise(p, {20, 60, 1}) + Noise(p, {5, 12, 2});
  });
  canvas.Shade([&](Point p) {
    const float leafy = 1.0f + 0.12f * lawn({p.x, 0.5f * p.y});
    Color color = trees.Cover(p, sky(p), Hex(0x8fb585) * leafy);
    const float hedge = 0.53f + 0.006f * lawn({p.x, 0.3f});
    color = Mix(color, Hex(0x649a52) * leafy, Smooth(hedge - 0.005f, hedge + 0.005f, p.y));
    const Color grass =
        Mix(Hex(0xbfdf90), kGrass, Smooth(0.63f, 1.0f, p.y)) * (1.0f + 0.05f * lawn(p));
    return Mix(color, grass, Smooth(0.635f, 0.645f, p.y));
  });
  Rng rng(0, "garden_view");
  PaintTree(&canvas, {0.2f, 0.74f}, 0.62f, Hex(0x78b055), &rng);
  PaintTree(&canvas, {0.84f, 0.7f}, 0.5f, Hex(0x86b85c), &rng);
  // A flower bed along the hedge and a path of stones to it.
  for (int i = 0; i < 60; ++i) {
    const Point at = {Between(rng, 0.32f, 0.76f), Between(rng, 0.6f, 0.655f)};
    constexpr Color kBlooms[] = {Hex(0xf2879b), Hex(0xffd95e), Hex(0xf7f2ff), Hex(0xe8604f),
                                 Hex(0xb08ad6)};
    const Color bloom = i % 3 == 0 ? Hex(0x5f9a4c) : OneOf(rng, kBlooms);
    canvas.Paint(Disc(at, Between(rng, 0.007f, 0.014f)), bloom);
  }
  for (int i = 0; i < 6; ++i) {
    const float t = static_cast<float>(i) / 6.0f;
    const Point at = {Mix(0.52f, 0.42f, t * t), Mix(0.7f, 0.97f, t)};
    const float size = Mix(0.025f, 0.075f, t);
    canvas.Paint(Ellipse{at, {size, 0.42f * size}}, Hex(0xe2dccf));
  }
  return canvas.Finish();
}

struct Building {
  Point corner;  // upper left
  float width = 0.1f;
  Color wall;
  float windows = 0.0f;  // how clearly they are seen
};

void PaintBuilding(Canvas* canvas, const Building& b, Rng* rng) {
  canvas->Paint(Rect{b.corner, {b.corner.x + b.width, 1.0f}}, [&](Point p) {
    return b.wall * Mix(1.04f, 0.88f, (p.x - b.corner.x) / b.width);
  });
  if (b.windows == 0.0f) return;
  const int columns = rng->Between(3, 5);
  const float pitch = b.width / static_cast<float>(columns);
  const Point half = Point{0.27f, 0.36f} * pitch;
  const int storeys = Floor((1.0f - b.corner.y) / (1.25f * pitch)) + 1;
  for (int i = 0; i < storeys * columns; ++i) {
    const Point cell = CellOf(i, columns);
    const Point at = b.corner + Point{cell.x + 0.5f, 1.25f * cell.y + 0.7f} * pitch;
    const Color glass = rng->Chance(0.25) ? Hex(0xdcebf5) : b.wall * 0.68f;
    canvas->Paint(Rect{at - half, at + half}, glass, {b.windows, 0.0f});
  }
}

/// A street's worth of buildings from the picture's left edge to its right; `near` is 0 for the
/// farthest, 1 for the nearest.
void PaintBlock(Canvas* canvas, float near, Rng* rng) {
  constexpr Color kWalls[] = {Hex(0xcdb79d), Hex(0xb7c3cf), Hex(0xd9cdbd), Hex(0xa8b1bd),
                              Hex(0xc29a85)};
  float x = -0.03f;
  while (x < 1.0f) {
    const float width = Between(*rng, 0.07f, 0.12f) * Mix(0.8f, 1.6f, near);
    const float top = Mix(0.3f, 0.64f, near) + Between(*rng, -0.12f, 0.12f);
    const Color wall = Mix(Hex(0xd3e0ec), OneOf(*rng, kWalls), Mix(0.25f, 0.95f, near));
    PaintBuilding(canvas, {{x, top}, width, wall, 0.95f * near}, rng);
    const Point roof = {x + 0.5f * width, top};
    if (near == 0.0f && rng->Chance(0.4)) {
      canvas->Paint(Stroke{roof, roof - Point{0.0f, 0.06f}, 0.006f}, wall);
    }
    x += width + Between(*rng, -0.005f, 0.012f);
  }
}

/// Rows of buildings, the far ones pale, the near ones with windows.
Image City() {
  Canvas canvas(Color{}, Edge::kClip);
  canvas.Shade(Sky(kZenith, kHorizon, 0.8f, 0.45f));
  Rng rng(0, "city_view");
  for (const float near : {0.0f, 0.5f, 1.0f}) PaintBlock(&canvas, near, &rng);
  return canvas.Finish();
}

/// Houses across the street, a pavement, a parked car.
Image Street() {
  Canvas canvas(Color{}, Edge::kClip);
  const Sky sky(kZenith, kHorizon, 0.6f, 0.5f);
  canvas.Shade([&](Point p) {
    Color color = Mix(sky(p), Hex(0xa9cc86), Smooth(0.695f, 0.7f, p.y));
    color = Mix(color, Hex(0xd7d3cb), Smooth(0.745f, 0.75f, p.y));
    color = Mix(color, Hex(0xa3a5a9), Smooth(0.795f, 0.8f, p.y));
    const float dash =
        Smooth(0.25f, 0.27f, Fraction(4.0f * p.x)) * Smooth(0.014f, 0.009f, std::abs(p.y - 0.9f));
    return Mix(color, Hex(0xf6f4ec), dash);
  });
  Rng rng(0, "street_view");
  PaintTree(&canvas, {0.36f, 0.68f}, 0.5f, Hex(0x93bd74), &rng);
  PaintTree(&canvas, {0.7f, 0.68f}, 0.44f, Hex(0x8bb86c), &rng);
  PaintHouse(&canvas, {{-0.06f, 0.7f}, 0.36f, 0.34f, Hex(0xeadbb9), Hex(0xa8624b), Hex(0x3f6e8c)});
  PaintHouse(&canvas, {{0.38f, 0.7f}, 0.28f, 0.33f, Hex(0xf1efe9), Hex(0x77818c), Hex(0xb6483c)});
  PaintHouse(&canvas, {{0.72f, 0.7f}, 0.34f, 0.36f, Hex(0xd8a489), Hex(0x8a5a48), Hex(0x4f7a52)});
  canvas.Paint(Rect{{0.06f, 0.83f}, {0.32f, 0.885f}, 0.02f}, Hex(0xd05a4a));
  canvas.Paint(Polygon{{0.1f, 0.835f}, {0.14f, 0.785f}, {0.24f, 0.785f}, {0.285f, 0.835f}},
               Hex(0xd05a4a));
  canvas.Paint(Polygon{{0.12f, 0.833f}, {0.147f, 0.797f}, {0.232f, 0.797f}, {0.262f, 0.833f}},
               Hex(0xcfe0ea));
  for (const float x : {0.12f, 0.26f}) {
    canvas.Paint(Disc({x, 0.885f}, 0.028f), Hex(0x4a4a4d));
    canvas.Paint(Disc({x, 0.885f}, 0.013f), Hex(0xc9ccd0));
  }
  PaintTree(&canvas, {0.68f, 0.78f}, 0.42f, Hex(0x7fb35b), &rng);
  return canvas.Finish();
}

/// Meadows and woods to a blue distance.
Image Hills() {
  Canvas canvas(Color{}, Edge::kClip);
  const Sky sky(kZenith, kHorizon, 0.55f, 0.55f);
  const Ridge far(0.47f, 0.13f, 11);
  const Ridge middle(0.56f, 0.11f, 12);
  const Ridge near(0.7f, 0.12f, 13);
  const Ridge meadow(0.86f, 0.1f, 14);
  const Field patches(128, 128, [](Point p) {
    return Noise(p, {4, 14, 1}) + 0.5f * Noise(p, {30, 90, 2});
  });
  canvas.Shade([&](Point p) {
    const float tone = 1.0f + 0.045f * patches(p);
    Color color = far.Cover(p, sky(p), Hex(0xb5cce0));
    color = middle.Cover(p, color, Hex(0x9fc0a6) * tone);
    color = near.Cover(
        p, color,
        Mix(Hex(0x8fbd72), Hex(0xc6d388), Smooth(-0.3f, 0.6f, patches({p.x, 2.0f * p.y}))) * tone);
    return meadow.Cover(p, color, Mix(Hex(0xa9d072), Hex(0x8dbd5c), p.y) * tone);
  });
  Rng rng(0, "hills_view");
  for (int i = 0; i < 26; ++i) {
    const float x = Between(rng, 0.0f, 1.0f);
    const float foot = near(x) + Between(rng, 0.005f, 0.05f);
    PaintTree(&canvas, {x, foot}, 0.07f, Hex(0x74a05c), &rng);
  }
  PaintTree(&canvas, {0.86f, 0.93f}, 0.36f, Hex(0x6fa34c), &rng);
  return canvas.Finish();
}

constexpr MaterialRecipe kRecipes[] = {
    {"city_view", MaterialFamily::kOther, 1.0f, City, false},
    {"garden_view", MaterialFamily::kOther, 1.0f, Garden, false},
    {"hills_view", MaterialFamily::kOther, 1.0f, Hills, false},
    {"street_view", MaterialFamily::kOther, 1.0f, Street, false},
};

}  // namespace

std::span<const MaterialRecipe> Views() {
  return kRecipes;
}

}  // namespace bulletnav::sim::materials
