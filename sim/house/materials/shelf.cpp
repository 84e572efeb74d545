// SPDX-License-Identifier: MIT
// What stands on shelves and hangs in wardrobes, seen from the front. Shown once.
#include "sim/house/materials/brushwork.h"
#include "sim/house/materials/families.h"
#include "sim/house/materials/motif.h"

namespace bulletnav::sim::materials {
namespace {

/// Back of a shelf: darker above, where the next shelf keeps the light away.
Canvas ShelfBack(Color color) {
  Canvas canvas(color, Edge::kClip);
  canvas.Shade([&](Point p) {
    return color * Mix(0.72f, 1.0f, Smooth(0.0f, 0.45f, p.y));
  });
  return canvas;
}

/// Shade of a round thing across its width.
auto Rounded(Color color, float left, float right) {
  return [=](Point p) {
    const float x = (p.x - left) / (right - left);
    return color * (0.72f + 0.42f * Smooth(0.0f, 0.35f, x) - 0.4f * Smooth(0.45f, 1.0f, x));
  };
}

struct BottleLook {
  float x = 0.0f;  // of its middle
  float width = 0.1f;
  float height = 0.8f;
  float neck = 0.3f;  // share of its height
  Color glass;
  Color label;
  Color cap;
};

void PaintBottle(Canvas* canvas, const BottleLook& b) {
  const float half = 0.5f * b.width;
  const float top = 0.99f - b.height;
  const float shoulder = top + b.neck * b.height;
  const auto glass = Rounded(b.glass, b.x - half, b.x + half);
  canvas->Paint(Rect{{b.x - half, shoulder}, {b.x + half, 0.99f}, 0.3f * half}, glass);
  canvas->Paint(Polygon{{b.x - half, shoulder + 0.35f * half},
                        {b.x - 0.3f * half, shoulder - 0.5f * half},
                        {b.x + 0.3f * half, shoulder - 0.5f * half},
                        {b.x + half, shoulder + 0.35f * half}},
                glass);
  canvas->Paint(Rect{{b.x - 0.32f * half, top}, {b.x + 0.32f * half, shoulder}}, glass);
  canvas->Paint(Rect{{b.x - 0.4f * half, top - 0.01f}, {b.x + 0.4f * half, top + 0.07f}, 0.008f},
                b.cap);
  const float body = 0.99f - shoulder;
  const Rect label = {{b.x - half, shoulder + 0.3f * body}, {b.x + half, shoulder + 0.75f * body}};
  canvas->Paint(label, Rounded(b.label, b.x - half, b.x + half));
  const float y = shoulder + 0.42f * body;
  canvas->Paint(Rect{{b.x - 0.6f * half, y}, {b.x + 0.6f * half, y + 0.08f * body}}, b.glass * 0.8f,
                {0.8f, 0.0f});
  canvas->Paint(Rect{{b.x - 0.5f * half, y + 0.16f * body}, {b.x + 0.5f * half, y + 0.2f * body}},
                b.glass * 0.8f, {0.6f, 0.0f});
}

Image Bottles() {
  constexpr Color kGlass[] = {Hex(0x3f6b45), Hex(0x7a4a26), Hex(0xd8e2dd), Hex(0x4f86b5),
                              Hex(0xc23f3a), Hex(0xe8c25a), Hex(0x2f4034), Hex(0xe9e6df)};
  constexpr Color kLabels[] = {Hex(0xf2ead6), Hex(0xe6d3a0), Hex(0xf6f6f2), Hex(0xd9d2e4),
                               Hex(0x2f3a56)};
  Canvas canvas = ShelfBack(Hex(0x9b8a77));
  Rng rng(0, "bottles");
  constexpr int kCount = 9;
  for (int i = 0; i < kCount; ++i) {
    const Color glass = kGlass[static_cast<std::size_t>(i * 3 + 1) % std::size(kGlass)];
    PaintBottle(&canvas, {(static_cast<float>(i) + 0.5f) / kCount, Between(rng, 0.072f, 0.1f),
                          Between(rng, 0.62f, 0.92f), Between(rng, 0.22f, 0.42f), glass,
                          OneOf(rng, kLabels), Mix(glass, Hex(0x2a2a2c), 0.6f)});
  }
  return canvas.Finish();
}

void PaintCereal(Canvas* canvas, const Rect& box, Color color, Rng* rng) {
  const float w = box.high.x - box.low.x;
  const float h = box.high.y - box.low.y;
  canvas->Paint(box, color);
  const auto at = [&](float x, float y) {
    return box.low + Point{x * w, y * h};
  };
  const Color accent = Hex(0xfdf6e3);
  canvas->Paint(Rect{at(0.1f, 0.1f), at(0.9f, 0.3f), 0.01f}, accent);
  Write(canvas, {{at(0.17f, 0.12f), at(0.88f, 0.28f)}, 2, 0.013f, color * 0.7f}, rng);
  canvas->Paint(Ellipse{at(0.5f, 0.66f), {0.36f * w, 0.2f * h}}, accent);
  canvas->Paint(Ellipse{at(0.5f, 0.64f), {0.27f * w, 0.12f * h}}, Mix(color, Hex(0xd89a4a), 0.7f));
  canvas->Paint(Rect{at(0.0f, 0.93f), at(1.0f, 1.0f)}, color * 0.75f);
  canvas->Paint(Rect{at(0.96f, 0.0f), at(1.0f, 1.0f)}, color * 0.8f);
}

void PaintTin(Canvas* canvas, const Rect& tin, Color label, Rng* rng) {
  const auto metal = Rounded(Hex(0xc6c9cc), tin.low.x, tin.high.x);
  const float h = tin.high.y - tin.low.y;
  canvas->Paint(tin, metal);
  canvas->Paint(Rect{{tin.low.x, tin.low.y + 0.1f * h}, {tin.high.x, tin.high.y - 0.1f * h}},
                Rounded(label, tin.low.x, tin.high.x));
  const float w = tin.high.x - tin.low.x;
  canvas->Paint(Ellipse{(tin.low + tin.high) * 0.5f, {0.3f * w, 0.2f * h}}, Hex(0xf6efdc));
  Write(canvas,
        {{{tin.low.x + 0.28f * w, tin.low.y + 0.4f * h},
          {tin.high.x - 0.25f * w, tin.low.y + 0.6f * h}},
         2,
         0.009f,
         label * 0.6f},
        rng);
}

void PaintJar(Canvas* canvas, const Rect& jar, Color contents) {
  const float h = jar.high.y - jar.low.y;
  canvas->Paint(Rect{{jar.low.x, jar.low.y + 0.12f * h}, jar.high, 0.02f},
                Rounded(contents, jar.low.x, jar.high.x));
  canvas->Paint(
      Rect{{jar.low.x, jar.low.y + 0.12f * h}, {jar.high.x, jar.low.y + 0.26f * h}, 0.015f},
      Rounded(Hex(0xdde6e6), jar.low.x, jar.high.x));
  canvas->Paint(
      Rect{{jar.low.x + 0.008f, jar.low.y}, {jar.high.x - 0.008f, jar.low.y + 0.15f * h}, 0.01f},
      Rounded(Hex(0xb0523c), jar.low.x, jar.high.x));
  canvas->Paint(Rect{{jar.low.x + 0.015f, jar.low.y + 0.48f * h},
                     {jar.high.x - 0.015f, jar.low.y + 0.76f * h}},
                Hex(0xf7f1e2));
}

Image FoodBoxes() {
  Canvas canvas = ShelfBack(Hex(0xcabfae));
  Rng rng(0, "food_boxes");
  const float floor = 0.99f;
  const auto standing = [&](float left, float width, float height) {
    return Rect{{left, floor - height}, {left + width, floor}};
  };
  PaintCereal(&canvas, standing(0.01f, 0.15f, 0.86f), Hex(0xd9483b), &rng);
  PaintCereal(&canvas, standing(0.165f, 0.14f, 0.78f), Hex(0x3f7fc1), &rng);
  PaintCereal(&canvas, standing(0.31f, 0.1f, 0.6f), Hex(0xe9b63a), &rng);
  PaintTin(&canvas, standing(0.425f, 0.095f, 0.33f), Hex(0xc94a35), &rng);
  canvas.Paint(Rect{{0.425f, 0.34f}, {0.52f, 0.66f}}, Rounded(Hex(0xc6c9cc), 0.425f, 0.52f));
  PaintTin(&canvas, {{0.425f, 0.335f}, {0.52f, 0.655f}}, Hex(0x4f8a4f), &rng);
  PaintJar(&canvas, standing(0.53f, 0.105f, 0.5f), Hex(0x8f2f3a));
  PaintJar(&canvas, standing(0.645f, 0.105f, 0.56f), Hex(0xd9a441));
  PaintCereal(&canvas, standing(0.76f, 0.13f, 0.82f), Hex(0x5aa061), &rng);
  PaintTin(&canvas, standing(0.9f, 0.09f, 0.36f), Hex(0xe08a3a), &rng);
  PaintTin(&canvas, {{0.9f, 0.26f}, {0.99f, 0.62f}}, Hex(0x3d6a9c), &rng);
  return canvas.Finish();
}

/// A row of clothes on hangers, their sleeves towards us.
Image Clothes() {
  constexpr Color kCloth[] = {Hex(0x2f3e58), Hex(0xf1eee6), Hex(0xa8443f), Hex(0x8fa7b8),
                              Hex(0x55595c), Hex(0xd8b98c), Hex(0x54705a), Hex(0xe7c6c4),
                              Hex(0x28282b), Hex(0xd9d4cb), Hex(0x7b5a74), Hex(0xcf9a3f)};
  Canvas canvas(Hex(0x5d4d40), Edge::kClip);
  canvas.Shade([](Point p) {
    return Hex(0x66564a) * Mix(0.85f, 0.6f, Smooth(0.2f, 1.0f, p.y));
  });
  canvas.Paint(Stroke{{-0.1f, 0.045f}, {1.1f, 0.045f}, 0.026f}, Hex(0xc4c7ca));
  Rng rng(0, "clothes");
  constexpr int kCount = 13;
  for (int i = 0; i < kCount; ++i) {
    const float x = (static_cast<float>(i) + 0.5f) / kCount + Between(rng, -0.006f, 0.006f);
    const float half = Between(rng, 0.034f, 0.05f);
    const float hem = Between(rng, 0.62f, 0.98f);
    const Color cloth =
        kCloth[static_cast<std::size_t>(i * 5) % std::size(kCloth)] * Between(rng, 0.94f, 1.06f);
    canvas.Paint(Ring{{x, 0.05f}, 0.02f, 0.007f}, Hex(0xb8bbbe));
    const Polygon garment = {{x - 0.012f, 0.09f},    {x + 0.012f, 0.09f},    {x + half, 0.17f},
                             {x + 1.1f * half, hem}, {x - 1.1f * half, hem}, {x - half, 0.17f}};
    const float fold = Between(rng, 0.0f, 1.0f);
    const bool striped = rng.Chance(0.2);
    canvas.Paint(garment, [&](Point p) {
      const float across = (p.x - x) / half;
      const float folds = 0.1f * (Wave(1.4f * across + fold + 0.5f * p.y) - 0.5f);
      const Color ground =
          striped && Wave(16.0f * p.y) > 0.5f ? Mix(cloth, Hex(0xf6f2ea), 0.6f) : cloth;
      return ground * (1.03f + folds - 0.26f * across * across);
    });
    // Sleeve.
    canvas.Paint(Stroke{{x - 0.1f * half, 0.19f}, {x - 0.02f, std::min(hem, 0.6f)}, 0.9f * half},
                 cloth * 0.9f, {0.55f, 0.012f});
    canvas.Paint(Stroke{{x + 1.1f * half, 0.2f}, {x + 1.2f * half, hem}, 0.008f}, Hex(0x2e2620),
                 {0.5f, 0.01f});
  }
  return canvas.Finish();
}

constexpr MaterialRecipe kRecipes[] = {
    {"bottles", MaterialFamily::kOther, 1.0f, Bottles, false},
    {"clothes", MaterialFamily::kOther, 1.0f, Clothes, false},
    {"food_boxes", MaterialFamily::kOther, 1.0f, FoodBoxes, false},
};

}  // namespace

std::span<const MaterialRecipe> Shelves() {
  return kRecipes;
}

}  // namespace bulletnav::sim::materials
