// SPDX-License-Identifier: MIT
#include "sim/house/materials/scenery.h"

#include "sim/house/materials/noise.h"

namespace bulletnav::sim::materials {

Sky::Sky(Color zenith, Color horizon, float skyline, float cover)
    : zenith_(zenith),
      horizon_(horizon),
      skyline_(skyline),
      cover_(cover),
      clouds_(128, 128, [](Point p) {
        return Fbm({p.x, 1.6f * p.y}, {3, 4, 3}, 5);
      }) {}

Color Sky::operator()(Point p) const {
  const float down = Clamp01(p.y / skyline_);
  const float cloud = clouds_(p) + 1.2f * (cover_ - 0.5f);
  const float white = Smooth(-0.1f, 0.6f, cloud) * (1.0f - 0.5f * down);
  // Thick clouds are grey below.
  const Color lit = Mix(Hex(0xfdfcf8), Hex(0xdfe2e6), Smooth(0.5f, 1.4f, cloud));
  return Mix(Mix(zenith_, horizon_, down), lit, 0.9f * white);
}

Ridge::Ridge(float base, float rise, std::uint32_t seed) {
  constexpr int kSamples = 256;
  for (int i = 0; i < kSamples; ++i) {
    const float x = (static_cast<float>(i) + 0.5f) / kSamples;
    const float broad = 0.5f + 0.5f * Noise({x, 0.3f}, {3, 1, seed});
    const float fine =
        0.2f * Noise({x, 0.7f}, {9, 1, seed}) + 0.06f * Noise({x, 0.6f}, {40, 1, seed});
    heights_.push_back(base - rise * (broad + fine));
  }
}

float Ridge::operator()(float x) const {
  const auto n = static_cast<int>(heights_.size());
  const int i = Floor(x * static_cast<float>(n));
  return heights_[static_cast<std::size_t>(std::clamp(i, 0, n - 1))];
}

Color Ridge::Cover(Point p, Color under, Color over) const {
  const float y = (*this)(p.x);
  return Mix(under, over, Smooth(y - 0.003f, y + 0.003f, p.y));
}

void PaintTree(Canvas* canvas, Point foot, float height, Color leaves, Rng* rng) {
  canvas->Paint(Stroke{foot, foot - Point{0.0f, 0.55f * height}, 0.06f * height}, Hex(0x6d5640));
  const int tufts = std::clamp(Round(280.0f * height), 14, 150);
  const float size = 0.42f * height / std::sqrt(static_cast<float>(tufts));
  for (int i = 0; i < tufts; ++i) {
    // From the shaded lower right to the lit upper left of the crown.
    const float light = static_cast<float>(i) / static_cast<float>(tufts);
    const float out = 0.27f * std::sqrt(Between(*rng, 0.0f, 1.0f));
    const Point spread = Turned({out, 0.0f}, Between(*rng, 0.0f, 6.28f));
    const Point lean = {Mix(0.05f, -0.05f, light), Mix(0.05f, -0.06f, light)};
    const Point at = foot + (Point{0.0f, -0.66f} + spread + lean) * height;
    const float radius = Between(*rng, 0.8f, 1.5f) * size;
    canvas->Paint(Ellipse{at, {radius, 0.8f * radius}},
                  leaves * (Mix(0.68f, 1.18f, light) * Between(*rng, 0.9f, 1.1f)));
  }
}

void PaintHouse(Canvas* canvas, const HouseLook& house) {
  const float w = house.width;
  const float h = house.height;
  const auto at = [&](float x, float y) {
    return house.foot + Point{x * w, -y * h};
  };
  const auto rect = [&](Point low, Point high, Color color) {
    canvas->Paint(
        Rect{{at(low.x, 0.0f).x, at(0.0f, high.y).y}, {at(high.x, 0.0f).x, at(0.0f, low.y).y}},
        color);
  };
  const float gable = 0.42f * w / h;
  canvas->Paint(Polygon{at(0.0f, 0.0f), at(0.0f, 1.0f), at(0.5f, 1.0f + gable), at(1.0f, 1.0f),
                        at(1.0f, 0.0f)},
                house.wall);
  for (const float side : {-1.0f, 1.0f}) {
    canvas->Paint(Stroke{at(0.5f, 1.04f + gable), at(0.5f + 0.57f * side, 0.97f), 0.07f * w},
                  house.roof);
  }
  const Color frame = Hex(0xf8f6f0);
  const auto window = [&](float x, float y) {
    const float tall = 0.26f;
    rect({x - 0.11f, y - 0.5f * tall}, {x + 0.11f, y + 0.5f * tall}, frame);
    rect({x - 0.085f, y - 0.42f * tall}, {x + 0.085f, y + 0.42f * tall}, Hex(0x6f8798));
    rect({x - 0.01f, y - 0.42f * tall}, {x + 0.01f, y + 0.42f * tall}, frame);
  };
  window(0.26f, 0.74f);
  window(0.74f, 0.74f);
  window(0.26f, 0.27f);
  window(0.5f, 1.0f + 0.32f * gable);
  rect({0.61f, 0.0f}, {0.85f, 0.44f}, frame);
  rect({0.635f, 0.0f}, {0.825f, 0.41f}, house.door);
}

}  // namespace bulletnav::sim::materials
