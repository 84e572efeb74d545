// SPDX-License-Identifier: MIT
// Paintings, without frames. Shown once.
#include "sim/base/elementary.h"
#include "sim/house/materials/brushwork.h"
#include "sim/house/materials/families.h"
#include "sim/house/materials/motif.h"
#include "sim/house/materials/noise.h"
#include "sim/house/materials/scenery.h"

namespace bulletnav::sim::materials {
namespace {

Image Landscape() {
  Canvas canvas(Color{}, Edge::kClip);
  const Sky sky(Hex(0x6fa3cf), Hex(0xf3e2c0), 0.5f, 0.5f);
  const Ridge mountains(0.5f, 0.16f, 1);
  const Ridge hills(0.56f, 0.1f, 2);
  const Ridge meadow(0.66f, 0.08f, 3);
  const Ridge field(0.78f, 0.06f, 4);
  canvas.Shade([&](Point p) {
    Color color = mountains.Cover(p, sky(p), Hex(0x8fa9bd));
    color = hills.Cover(p, color, Hex(0x7f9c7a));
    color = meadow.Cover(p, color, Mix(Hex(0x6f9448), Hex(0x97ab52), p.x));
    color = field.Cover(p, color, Mix(Hex(0xdcb954), Hex(0xb98a3a), Smooth(0.7f, 1.0f, p.y)));
    // A path winding up through the field.
    const float middle = 0.45f + 0.1f * Sin(9.0f * p.y) + 0.25f * (p.y - 0.75f);
    const float half = 0.2f * (p.y - 0.64f);
    const float path =
        Smooth(0.7f, 0.76f, p.y) * Smooth(half, half - 0.02f, std::abs(p.x - middle));
    return Mix(color, Hex(0xead9b4), path);
  });
  Rng rng(0, "painting_landscape");
  PaintTree(&canvas, {0.3f, 0.72f}, 0.24f, Hex(0x58863f), &rng);
  PaintTree(&canvas, {0.15f, 0.8f}, 0.42f, Hex(0x4d7a3a), &rng);
  PaintTree(&canvas, {0.78f, 0.73f}, 0.24f, Hex(0x567f3c), &rng);
  PaintTree(&canvas, {0.9f, 0.78f}, 0.34f, Hex(0x46703a), &rng);
  canvas.Paint(Rect{{0.58f, 0.6f}, {0.68f, 0.665f}}, Hex(0xefe3cf));
  canvas.Paint(Polygon{{0.565f, 0.605f}, {0.63f, 0.555f}, {0.695f, 0.605f}}, Hex(0xb5503a));
  PaintOver(&canvas, {.strokes = 2200, .length = 0.04f, .width = 0.013f}, &rng);
  return canvas.Finish();
}

Image Sea() {
  Canvas canvas(Color{}, Edge::kClip);
  const Sky sky(Hex(0x5d88b5), Hex(0xf6c795), 0.5f, 0.45f);
  const Field swells(64, 128, [](Point p) {
    return Noise(p, {4, 14, 2}) + 0.5f * Noise(p, {12, 30, 3});
  });
  canvas.Shade([&](Point p) {
    if (p.y < 0.48f) return sky(p);
    const float depth = (p.y - 0.48f) / 0.52f;
    const float swell = swells({p.x, std::sqrt(depth)});
    const Color water = Mix(Hex(0x7fa7b8), Hex(0x1f4f74), Smooth(0.0f, 0.9f, depth));
    const float glitter = Smooth(0.14f, 0.02f, std::abs(p.x - 0.66f)) * Smooth(0.2f, 0.6f, swell);
    const Color lit = Mix(water * (1.0f + 0.16f * swell), Hex(0xffdca8), 0.8f * glitter);
    return Mix(lit, Hex(0xeef4f2), Smooth(0.75f, 1.0f, swell) * depth);
  });
  canvas.Paint(Disc({0.66f, 0.38f}, 0.05f), Hex(0xffe9b8), {1.0f, 0.02f});
  const Color sail = Hex(0xf7f0e2);
  canvas.Paint(Polygon{{0.3f, 0.26f}, {0.3f, 0.55f}, {0.16f, 0.55f}}, sail);
  canvas.Paint(Polygon{{0.32f, 0.3f}, {0.32f, 0.55f}, {0.42f, 0.55f}}, sail * 0.88f);
  canvas.Paint(Stroke{{0.31f, 0.24f}, {0.31f, 0.59f}, 0.01f}, Hex(0x5b4433));
  canvas.Paint(Polygon{{0.15f, 0.57f}, {0.45f, 0.57f}, {0.4f, 0.62f}, {0.2f, 0.62f}},
               Hex(0x7d3b2e));
  Rng rng(0, "painting_sea");
  PaintOver(&canvas, {.strokes = 2200, .length = 0.05f, .width = 0.012f, .sway = 0.25f}, &rng);
  return canvas.Finish();
}

Image Portrait() {
  Canvas canvas(Color{}, Edge::kClip);
  canvas.Shade([](Point p) {
    return Mix(Hex(0x75604a), Hex(0x33291f), Smooth(0.05f, 0.65f, Length(p - Point{0.38f, 0.36f})));
  });
  const Color skin = Hex(0xe6b995);
  const Color hair = Hex(0x4a2f20);
  canvas.Paint(Ellipse{{0.5f, 0.42f}, {0.23f, 0.27f}}, hair);
  canvas.Paint(Ellipse{{0.5f, 0.57f}, {0.215f, 0.2f}}, hair * 0.9f);
  canvas.Paint(Ellipse{{0.5f, 1.06f}, {0.43f, 0.33f}}, Hex(0x2f4a63));
  canvas.Paint(Rect{{0.43f, 0.58f}, {0.57f, 0.78f}, 0.04f}, skin * 0.86f);
  canvas.Paint(
      Polygon{{0.36f, 0.77f}, {0.5f, 0.92f}, {0.64f, 0.77f}, {0.57f, 0.72f}, {0.43f, 0.72f}},
      Hex(0xf1ead8));
  canvas.Paint(Ellipse{{0.5f, 0.45f}, {0.16f, 0.205f}}, [&](Point p) {
    return skin * Mix(1.04f, 0.72f, Smooth(0.44f, 0.67f, p.x + 0.15f * (p.y - 0.45f)));
  });
  // A parting: hair over the brow.
  canvas.Paint(Leaf{{0.48f, 0.225f}, {0.345f, 0.43f}, 0.09f}, hair);
  canvas.Paint(Leaf{{0.46f, 0.225f}, {0.655f, 0.43f}, 0.105f}, hair);
  for (const float side : {-1.0f, 1.0f}) {
    const Point eye = {0.5f + side * 0.062f, 0.435f};
    canvas.Paint(Leaf{eye - Point{0.036f, 0.0f}, eye + Point{0.036f, 0.0f}, 0.026f}, Hex(0xf4ece2));
    canvas.Paint(Disc(eye, 0.0135f), Hex(0x3a2a22));
    canvas.Paint(Stroke{eye + Point{-0.038f, -0.034f}, eye + Point{0.036f, -0.04f}, 0.012f}, hair);
    canvas.Paint(Ellipse{{0.5f + side * 0.085f, 0.52f}, {0.035f, 0.026f}}, Hex(0xdb8f78),
                 {0.45f, 0.03f});
  }
  canvas.Paint(Stroke{{0.506f, 0.44f}, {0.518f, 0.515f}, 0.014f}, skin * 0.78f, {0.7f, 0.008f});
  canvas.Paint(Leaf{{0.46f, 0.575f}, {0.545f, 0.575f}, 0.03f}, Hex(0xa94f48));
  Rng rng(0, "painting_portrait");
  PaintOver(&canvas,
            {.strokes = 3000, .length = 0.02f, .width = 0.0085f, .angle = 1.2f, .sway = 1.0f},
            &rng);
  return canvas.Finish();
}

Image Flowers() {
  Canvas canvas(Color{}, Edge::kClip);
  canvas.Shade([](Point p) {
    const Color wall = Mix(Hex(0xd9d2b8), Hex(0xa3ab9b), Smooth(0.1f, 1.0f, p.x + 0.4f * p.y));
    return Mix(wall, Mix(Hex(0xa8794f), Hex(0x7d5335), p.x), Smooth(0.775f, 0.785f, p.y));
  });
  Rng rng(0, "painting_flowers");
  canvas.Paint(Ellipse{{0.6f, 0.88f}, {0.24f, 0.04f}}, Hex(0x5d3d28), {0.7f, 0.03f});
  for (int i = 0; i < 26; ++i) {
    const float turn = Between(rng, -1.5f, 1.5f);
    const Point root = {0.5f, 0.58f};
    const Point tip = root + Turned({0.0f, -Between(rng, 0.25f, 0.42f)}, turn);
    canvas.Paint(Leaf{root, tip, 0.06f},
                 Mix(Hex(0x3f6b3a), Hex(0x86a45a), Between(rng, 0.0f, 1.0f)));
  }
  canvas.Paint(Ellipse{{0.5f, 0.73f}, {0.13f, 0.15f}}, [](Point p) {
    return Hex(0x5d86ad) * Mix(1.25f, 0.65f, Smooth(0.38f, 0.63f, p.x));
  });
  canvas.Paint(Rect{{0.44f, 0.555f}, {0.56f, 0.63f}, 0.01f}, Hex(0x5a82a8));
  constexpr Color kPetals[] = {Hex(0xd6455a), Hex(0xf0a3b0), Hex(0xf4d35e),
                               Hex(0xf6f0e6), Hex(0xe98344), Hex(0x9a6fb0)};
  constexpr Point kPlaces[] = {{0.5f, 0.17f},  {0.33f, 0.24f}, {0.67f, 0.23f}, {0.21f, 0.4f},
                               {0.79f, 0.38f}, {0.42f, 0.36f}, {0.6f, 0.38f},  {0.31f, 0.52f},
                               {0.71f, 0.53f}, {0.5f, 0.5f}};
  for (std::size_t i = 0; i < std::size(kPlaces); ++i) {
    const float radius = Between(rng, 0.075f, 0.105f);
    PaintFlower(&canvas, kPlaces[i], radius, Between(rng, 0.0f, 1.0f),
                {7, kPetals[i % std::size(kPetals)], Hex(0xb8862f)});
  }
  PaintOver(&canvas,
            {.strokes = 2400, .length = 0.026f, .width = 0.011f, .angle = 0.8f, .sway = 1.2f},
            &rng);
  return canvas.Finish();
}

/// Broad bands of colour under loose gestures.
Image Abstract() {
  Canvas canvas(Hex(0xefe6d6), Edge::kClip);
  Rng rng(0, "painting_abstract");
  canvas.Paint(Rect{{-0.1f, -0.1f}, {0.62f, 0.5f}, 0.02f}, Hex(0xd9583b), {0.95f, 0.03f});
  canvas.Paint(Rect{{0.3f, 0.42f}, {1.1f, 0.93f}, 0.02f}, Hex(0x27566b), {0.95f, 0.03f});
  canvas.Paint(Ellipse{{0.76f, 0.26f}, {0.25f, 0.23f}}, Hex(0xf0b63c), {0.95f, 0.02f});
  canvas.Paint(Ellipse{{0.2f, 0.76f}, {0.26f, 0.19f}, 0.5f}, Hex(0x8fb8a8), {0.9f, 0.02f});
  PaintOver(&canvas, {.strokes = 700, .length = 0.13f, .width = 0.03f, .angle = 0.4f, .sway = 0.9f},
            &rng);
  constexpr Color kInks[] = {Hex(0x1e1e22), Hex(0xf7f2e8), Hex(0xc23a32)};
  for (int i = 0; i < 9; ++i) {
    Point at = Anywhere(rng);
    float angle = Between(rng, 0.0f, 6.28f);
    const float width = Between(rng, 0.008f, 0.028f);
    for (int step = 0; step < 14; ++step) {
      const Point next = at + Turned({0.04f, 0.0f}, angle);
      canvas.Paint(Stroke{at, next, width * (1.0f - 0.05f * static_cast<float>(step))},
                   kInks[i % 3], {0.9f, 0.0f});
      at = next;
      angle += Between(rng, -0.1f, 0.45f);
    }
  }
  return canvas.Finish();
}

/// Half a disc standing on its diameter.
Polygon Arch(Point centre, float radius) {
  constexpr int kSides = 24;
  std::vector<Point> outline;
  for (int k = 0; k <= kSides; ++k) {
    outline.push_back(centre + Turned({-radius, 0.0f}, kPi * static_cast<float>(k) / kSides));
  }
  return Polygon(outline);
}

/// Arches, discs and blocks in flat colours.
Image Geometric() {
  constexpr Color kPaper = Hex(0xf1e8d8);
  constexpr Color kInk = Hex(0x2f4858);
  constexpr Color kBrick = Hex(0xc8553d);
  constexpr Color kMaize = Hex(0xe3b04b);
  Canvas canvas(kPaper, Edge::kClip);
  canvas.Paint(Rect{{0.08f, 0.08f}, {0.5f, 0.5f}}, kMaize);
  canvas.Paint(Rect{{0.5f, 0.08f}, {0.92f, 0.36f}}, kInk);
  canvas.Paint(Rect{{0.08f, 0.5f}, {0.36f, 0.92f}}, kBrick);
  canvas.Paint(Rect{{0.36f, 0.64f}, {0.92f, 0.92f}}, Hex(0x8fb0a6));
  for (const float share : {1.0f, 0.72f, 0.44f}) {
    const bool paper = share == 0.72f;
    canvas.Paint(Arch({0.29f, 0.5f}, 0.19f * share), paper ? kPaper : kInk);
    canvas.Paint(Arch({0.64f, 0.92f}, 0.24f * share), paper ? kPaper : kBrick);
  }
  canvas.Paint(Disc({0.71f, 0.5f}, 0.17f), Hex(0xd9713f));
  canvas.Paint(Disc({0.71f, 0.5f}, 0.085f), kPaper);
  canvas.Paint(Disc({0.22f, 0.71f}, 0.08f), kMaize);
  canvas.Shade([](Point p, Color c) {
    return c * (1.0f + 0.02f * Noise(p, {90, 90, 1}));
  });
  return canvas.Finish();
}

constexpr MaterialRecipe kRecipes[] = {
    {"painting_abstract", MaterialFamily::kOther, 1.0f, Abstract, false},
    {"painting_flowers", MaterialFamily::kOther, 1.0f, Flowers, false},
    {"painting_geometric", MaterialFamily::kOther, 1.0f, Geometric, false},
    {"painting_landscape", MaterialFamily::kOther, 1.0f, Landscape, false},
    {"painting_portrait", MaterialFamily::kOther, 1.0f, Portrait, false},
    {"painting_sea", MaterialFamily::kOther, 1.0f, Sea, false},
};

}  // namespace

std::span<const MaterialRecipe> Paintings() {
  return kRecipes;
}

}  // namespace bulletnav::sim::materials
