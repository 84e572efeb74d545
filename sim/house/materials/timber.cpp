// SPDX-License-Identifier: MIT
#include "sim/house/materials/timber.h"

namespace bulletnav::sim::materials {
namespace {

constexpr float kRingsPerMetre = 26.0f;
constexpr int kAlong = 64;  // samples along the grain, where everything changes slowly
constexpr int kAcross = 256;
constexpr int kKnotSamples = 128;

/// Noise of so many cells a metre, but none finer than two of a picture's pixels.
Lattice Grain(float along, float across, float metres, std::uint32_t seed) {
  const auto cells = [&](float per_metre, int most) {
    return std::clamp(Round(per_metre * metres), 1, most);
  };
  return {cells(along, kAlong / 2), cells(across, kAcross / 2), seed};
}

}  // namespace

Log::Log(const Timber& timber, float metres)
    : timber_(timber),
      lines_(static_cast<float>(Round(kRingsPerMetre * metres))),
      streaks_(kAlong, kAcross,
               [&](Point p) {
                 const float fibre = 0.6f * Noise(p, Grain(3.0f, 60.0f, metres, 1)) +
                                     0.5f * Noise(p, Grain(8.0f, 110.0f, metres, 2));
                 const float pore = Smooth(0.35f, 0.9f, Noise(p, Grain(9.0f, 128.0f, metres, 5)));
                 return timber.streaks * fibre - timber.pores * pore;
               }),
      bend_(kAlong, kAlong,
            [&](Point p) {
              return timber.rings * Noise(p, Grain(1.2f, 5.0f, metres, 3));
            }),
      to_knot_(timber.knots > 0.0f ? kKnotSamples : 1, timber.knots > 0.0f ? kKnotSamples : 1,
               [&](Point p) {
                 const Nearest nearest = Scatter(p, Grain(3.0f, 5.0f, metres, 4));
                 if (Random(nearest.id) >= timber.knots) return 1.0f;
                 return std::min(1.0f, Length({nearest.offset.x, 1.4f * nearest.offset.y}));
               }) {}

Color Log::operator()(Point p, std::uint32_t id) const {
  const Point q = p + Point{Random(id, 1), Random(id, 2)};
  // Where the height of the growth rings passes whole numbers, a ring comes to the surface: lines
  // along the grain, bent into flames.
  float height = lines_ * q.y + bend_(q);
  float knot = 0.0f;
  if (timber_.knots > 0.0f) {
    const float far = to_knot_(q);
    const float bump = Smooth(0.35f, 0.0f, far);
    height += 2.5f * bump * bump;
    knot = Smooth(0.09f, 0.04f, far);
  }
  const float tone = 0.5f + streaks_(q) + timber_.figure * (Wave(height) - 0.5f) +
                     timber_.spread * (Random(id, 3) - 0.5f);
  const Color wood = Mix(timber_.dark, timber_.light, tone);
  return Mix(wood, timber_.dark * 0.62f, 0.85f * knot);
}

}  // namespace bulletnav::sim::materials
