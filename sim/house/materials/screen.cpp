// SPDX-License-Identifier: MIT
// Fronts of appliances and instruments. Shown once.
#include "sim/house/materials/brushwork.h"
#include "sim/house/materials/families.h"
#include "sim/house/materials/noise.h"
#include "sim/house/materials/scenery.h"

namespace bulletnav::sim::materials {
namespace {

/// Switched off: the room's window mirrored in black glass, a thin frame around it.
Image Television() {
  Canvas canvas(Hex(0x1c1e22), Edge::kClip);
  canvas.Shade([](Point p) {
    const float sheen = Smooth(0.9f, 0.1f, p.x + 0.7f * p.y);
    return Mix(Hex(0x17191d), Hex(0x3d434c), 0.8f * sheen);
  });
  // Four panes in perspective.
  for (int i = 0; i < 4; ++i) {
    const Point pane = CellOf(i, 2);
    const float x = 0.6f + 0.115f * pane.x;
    const float y = 0.18f + 0.2f * pane.y;
    canvas.Paint(
        Polygon{{x, y}, {x + 0.105f, y + 0.012f}, {x + 0.105f, y + 0.18f}, {x, y + 0.185f}},
        Hex(0x7e8b99), {0.55f, 0.02f});
  }
  canvas.Paint(Rect{{-0.1f, 0.97f}, {1.1f, 1.1f}}, Hex(0x2c2e32));
  canvas.Paint(Rect{{0.47f, 0.98f}, {0.53f, 0.99f}}, Hex(0x8a8f96));
  for (const Rect& edge : {Rect{{0.0f, 0.0f}, {0.012f, 1.0f}}, Rect{{0.988f, 0.0f}, {1.0f, 1.0f}},
                           Rect{{0.0f, 0.0f}, {1.0f, 0.016f}}}) {
    canvas.Paint(edge, Hex(0x101114));
  }
  return canvas.Finish();
}

void PaintWindow(Canvas* canvas, const Rect& window, Color title, Rng* rng) {
  canvas->Paint(Rect{window.low + Point{0.008f, 0.012f}, window.high + Point{0.008f, 0.012f}},
                Hex(0x1c2a3c), {0.35f, 0.02f});
  canvas->Paint(window, Hex(0xf7f8fa));
  canvas->Paint(Rect{window.low, {window.high.x, window.low.y + 0.055f}}, title);
  for (int i = 0; i < 3; ++i) {
    const Point at = {window.high.x - 0.025f - 0.03f * static_cast<float>(i),
                      window.low.y + 0.028f};
    canvas->Paint(Disc(at, 0.009f), Hex(0xf0f2f4));
  }
  Write(canvas,
        {{window.low + Point{0.03f, 0.09f}, window.high - Point{0.03f, 0.04f}},
         9,
         0.012f,
         Hex(0x59626e)},
        rng);
}

Image Computer() {
  Canvas canvas(Color{}, Edge::kClip);
  const Ridge hills(0.75f, 0.25f, 21);
  canvas.Shade([&](Point p) {
    return hills.Cover(p, Mix(Hex(0x4f9be0), Hex(0xbfe0f6), p.y),
                       Mix(Hex(0x3f9a9c), Hex(0x2f6f86), p.y));
  });
  Rng rng(0, "computer_screen");
  PaintWindow(&canvas, {{0.1f, 0.1f}, {0.6f, 0.72f}}, Hex(0x3c5f99), &rng);
  PaintWindow(&canvas, {{0.5f, 0.34f}, {0.93f, 0.84f}}, Hex(0x5d6672), &rng);
  constexpr Color kBars[] = {Hex(0xe57a4a), Hex(0x4f9be0), Hex(0x6bbf71), Hex(0xf0c24a)};
  canvas.Paint(Rect{{0.53f, 0.42f}, {0.9f, 0.62f}}, Hex(0xe9edf2));
  for (std::size_t i = 0; i < 8; ++i) {
    const float x = 0.555f + 0.042f * static_cast<float>(i);
    canvas.Paint(Rect{{x, Between(rng, 0.45f, 0.56f)}, {x + 0.026f, 0.61f}}, kBars[i % 4]);
  }
  canvas.Paint(Rect{{-0.1f, 0.93f}, {1.1f, 1.1f}}, Hex(0x1f2a3a));
  for (int i = 0; i < 6; ++i) {
    const float x = 0.03f + 0.06f * static_cast<float>(i);
    canvas.Paint(Rect{{x, 0.943f}, {x + 0.035f, 0.985f}, 0.006f},
                 kBars[static_cast<std::size_t>(i) % 4]);
  }
  return canvas.Finish();
}

/// Fifteen columns of keys in five rows, stretched over a board three times as wide as deep.
Image Keyboard() {
  Canvas canvas(Hex(0x3a3c40), Edge::kClip);
  constexpr int kRows = 5;
  const auto key = [&](float left, float right, int row) {
    const float top = 0.06f + 0.178f * static_cast<float>(row);
    canvas.Paint(Rect{{left + 0.006f, top + 0.012f}, {right - 0.006f, top + 0.166f}, 0.012f},
                 Hex(0x8d9096));
    canvas.Paint(Rect{{left + 0.009f, top + 0.016f}, {right - 0.009f, top + 0.135f}, 0.012f},
                 Hex(0xd5d7da));
    const Point legend = {left + 0.024f, top + 0.05f};
    canvas.Paint(Rect{legend - Point{0.006f, 0.016f}, legend + Point{0.006f, 0.016f}},
                 Hex(0x5a5d62));
  };
  for (int row = 0; row < kRows - 1; ++row) {
    const float wide = 0.07f + 0.02f * static_cast<float>(row);
    key(0.03f, 0.03f + wide, row);
    constexpr float kPitch = 0.0615f;
    float x = 0.03f + wide;
    while (x + kPitch < 0.9f) {
      key(x, x + kPitch, row);
      x += kPitch;
    }
    key(x, 0.97f, row);
  }
  key(0.03f, 0.12f, kRows - 1);
  key(0.12f, 0.2f, kRows - 1);
  key(0.2f, 0.28f, kRows - 1);
  key(0.28f, 0.68f, kRows - 1);
  key(0.68f, 0.76f, kRows - 1);
  key(0.76f, 0.86f, kRows - 1);
  key(0.86f, 0.97f, kRows - 1);
  return canvas.Finish();
}

/// Ten past ten. The dial fills the picture; what a round clock leaves of it is the rim's colour.
Image Clock() {
  const Point middle = {0.5f, 0.5f};
  Canvas canvas(Hex(0x3a3431), Edge::kClip);
  canvas.Paint(Disc(middle, 0.455f), Hex(0xf8f5ec));
  for (int i = 0; i < 60; ++i) {
    const float turn = kPi * static_cast<float>(i) / 30.0f;
    const bool hour = i % 5 == 0;
    const Point out = Turned({0.0f, -0.425f}, turn);
    canvas.Paint(
        Stroke{middle + out, middle + out * (hour ? 0.84f : 0.95f), hour ? 0.026f : 0.008f},
        Hex(0x2b2826));
  }
  const auto hand = [&](float turn, float length, float width, Color color) {
    const Point tip = Turned({0.0f, -length}, turn);
    canvas.Paint(Stroke{middle - tip * 0.18f, middle + tip, width}, color);
  };
  hand(2.0f * kPi * (10.0f + 1.0f / 6.0f) / 12.0f, 0.22f, 0.034f, Hex(0x1f1d1c));
  hand(2.0f * kPi / 6.0f, 0.33f, 0.024f, Hex(0x1f1d1c));
  hand(2.0f * kPi * 0.6f, 0.36f, 0.01f, Hex(0xb9382f));
  canvas.Paint(Disc(middle, 0.026f), Hex(0x1f1d1c));
  return canvas.Finish();
}

/// Steel front: knobs and a clock above, a handle, a dark window with a lit inside.
Image Oven() {
  Canvas canvas(Color{}, Edge::kClip);
  canvas.Shade([](Point p) {
    return Hex(0xc3c6c8) * (1.0f + 0.02f * Noise(p, {2, 110, 1}) + 0.08f * (Wave(p.x) - 0.5f));
  });
  canvas.Paint(Rect{{-0.1f, 0.185f}, {1.1f, 0.195f}}, Hex(0x5c5f62));
  canvas.Paint(Rect{{0.38f, 0.05f}, {0.62f, 0.14f}, 0.01f}, Hex(0x1d2125));
  Rng rng(0, "oven_front");
  Write(&canvas, {{{0.42f, 0.07f}, {0.58f, 0.12f}}, 1, 0.022f, Hex(0x69d0e6)}, &rng);
  for (const float x : {0.09f, 0.2f, 0.31f, 0.69f, 0.8f, 0.91f}) {
    canvas.Paint(Disc({x, 0.1f}, 0.042f), Hex(0x777b7f));
    canvas.Paint(Disc({x, 0.095f}, 0.035f), Hex(0x2f3235));
    canvas.Paint(Stroke{{x, 0.09f}, {x, 0.068f}, 0.008f}, Hex(0xf0f0f0));
  }
  canvas.Paint(Rect{{0.08f, 0.25f}, {0.92f, 0.305f}, 0.02f}, Hex(0x5f6366), {0.6f, 0.02f});
  canvas.Paint(Rect{{0.08f, 0.235f}, {0.92f, 0.28f}, 0.02f}, [](Point p) {
    return Hex(0xe6e8ea) * (1.05f - 8.0f * std::abs(p.y - 0.25f));
  });
  canvas.Paint(Rect{{0.08f, 0.35f}, {0.92f, 0.93f}, 0.025f}, Hex(0x222427));
  canvas.Paint(Rect{{0.15f, 0.41f}, {0.85f, 0.87f}, 0.02f}, [](Point p) {
    const Color glow =
        Mix(Hex(0x2c2622), Hex(0x6e4f33), Smooth(0.5f, 0.0f, Length(p - Point{0.5f, 0.55f})));
    const float rack = Smooth(0.008f, 0.004f, std::abs(Fraction(6.0f * p.y) - 0.5f) / 6.0f);
    return Mix(glow, Hex(0x8f8a84), 0.5f * rack);
  });
  canvas.Paint(Polygon{{0.2f, 0.87f}, {0.45f, 0.41f}, {0.56f, 0.41f}, {0.31f, 0.87f}},
               Hex(0xffffff), {0.09f, 0.01f});
  return canvas.Finish();
}

/// A mirror cannot show the room here: it shows light, cool and blurred.
Image Mirror() {
  Canvas canvas(Color{}, Edge::kClip);
  canvas.Shade([](Point p) {
    const Color deep =
        Mix(Hex(0xdfe8ee), Hex(0xa9bac6), Smooth(0.0f, 1.0f, 0.75f * p.y + 0.25f * p.x));
    const float slant = p.x + 0.75f * p.y;
    const float broad = Smooth(0.42f, 0.47f, slant) * Smooth(0.72f, 0.67f, slant);
    const float thin = Smooth(0.78f, 0.8f, slant) * Smooth(0.86f, 0.84f, slant);
    return deep + Grey(15.0f * broad + 13.0f * thin);
  });
  for (const Rect& bevel : {Rect{{0.0f, 0.0f}, {1.0f, 0.02f}}, Rect{{0.0f, 0.0f}, {0.02f, 1.0f}}}) {
    canvas.Paint(bevel, Hex(0xf6fafc), {0.7f, 0.0f});
  }
  for (const Rect& bevel : {Rect{{0.0f, 0.98f}, {1.0f, 1.0f}}, Rect{{0.98f, 0.0f}, {1.0f, 1.0f}}}) {
    canvas.Paint(bevel, Hex(0x8598a6), {0.7f, 0.0f});
  }
  return canvas.Finish();
}

/// Sums and a drawing in chalk over wiped ones.
Image Blackboard() {
  Canvas canvas(Color{}, Edge::kClip);
  const Field wiped(64, 64, [](Point p) {
    return Fbm({p.x, p.y}, {3, 6, 1}, 3);
  });
  canvas.Shade([&](Point p) {
    return Hex(0x3f5348) * (1.05f + 0.12f * wiped(p));
  });
  const Color chalk = Hex(0xe8ebe4);
  Rng rng(0, "blackboard");
  Write(&canvas, {{{0.08f, 0.1f}, {0.6f, 0.5f}}, 4, 0.02f, chalk}, &rng);
  Write(&canvas, {{{0.08f, 0.6f}, {0.5f, 0.88f}}, 3, 0.02f, Hex(0xf0dfa0)}, &rng);
  // A house under a sun.
  const auto line = [&](Point a, Point b) {
    canvas.Paint(Stroke{a, b, 0.014f}, chalk, {0.85f, 0.0f});
  };
  line({0.66f, 0.88f}, {0.66f, 0.62f});
  line({0.9f, 0.88f}, {0.9f, 0.62f});
  line({0.63f, 0.64f}, {0.78f, 0.47f});
  line({0.93f, 0.64f}, {0.78f, 0.47f});
  line({0.63f, 0.88f}, {0.93f, 0.88f});
  line({0.75f, 0.88f}, {0.75f, 0.74f});
  line({0.82f, 0.88f}, {0.82f, 0.74f});
  line({0.75f, 0.74f}, {0.82f, 0.74f});
  canvas.Paint(Ring{{0.84f, 0.2f}, 0.07f, 0.014f}, Hex(0xf4d98a));
  for (int i = 0; i < 8; ++i) {
    const Point ray = Turned({0.0f, 0.1f}, kPi * static_cast<float>(i) / 4.0f);
    canvas.Paint(Stroke{Point{0.84f, 0.2f} + ray, Point{0.84f, 0.2f} + ray * 1.35f, 0.012f},
                 Hex(0xf4d98a));
  }
  return canvas.Finish();
}

constexpr MaterialRecipe kRecipes[] = {
    {"blackboard", MaterialFamily::kOther, 1.0f, Blackboard, false},
    {"clock_face", MaterialFamily::kOther, 1.0f, Clock, false},
    {"computer_screen", MaterialFamily::kOther, 1.0f, Computer, false},
    {"keyboard", MaterialFamily::kOther, 1.0f, Keyboard, false},
    {"mirror", MaterialFamily::kOther, 1.0f, Mirror, false},
    {"oven_front", MaterialFamily::kOther, 1.0f, Oven, false},
    {"tv_screen", MaterialFamily::kOther, 1.0f, Television, false},
};

}  // namespace

std::span<const MaterialRecipe> Screens() {
  return kRecipes;
}

}  // namespace bulletnav::sim::materials
