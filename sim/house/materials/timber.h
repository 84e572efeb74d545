// SPDX-License-Identifier: MIT
#pragma once
#include "sim/house/materials/field.h"
#include "sim/house/materials/noise.h"

namespace bulletnav::sim::materials {

/// A kind of wood, as sawn.
struct Timber {
  Color light;
  Color dark;
  float streaks = 0.3f;  // fine lines along the grain
  float figure = 0.15f;  // contrast of the growth rings
  float rings = 4.0f;    // how far they are bent into flames
  float pores = 0.5f;    // short dark dashes
  float spread = 0.5f;   // difference between boards
  float knots = 0.0f;    // chance of one in a patch of about 30 by 20 cm
};

// The kinds that houses are built of.
inline constexpr Timber kOak = {.light = Hex(0xdab68a),
                                .dark = Hex(0xae875b),
                                .streaks = 0.32f,
                                .figure = 0.16f,
                                .pores = 0.6f,
                                .spread = 0.75f};
inline constexpr Timber kWalnut = {.light = Hex(0x8c6444),
                                   .dark = Hex(0x523626),
                                   .streaks = 0.32f,
                                   .figure = 0.24f,
                                   .rings = 5.0f,
                                   .pores = 0.6f,
                                   .spread = 0.8f};
inline constexpr Timber kPine = {.light = Hex(0xecc78f),
                                 .dark = Hex(0xcb9453),
                                 .streaks = 0.2f,
                                 .figure = 0.34f,
                                 .pores = 0.0f,
                                 .spread = 0.6f,
                                 .knots = 0.5f};

/// Boards of one timber for a picture `metres` wide. Every board is cut from another place of the
/// same log, which repeats with the picture.
class Log {
 public:
  Log(const Timber& timber, float metres);

  /// Colour of board `id` at p, x along the grain.
  Color operator()(Point p, std::uint32_t id) const;

 private:
  Timber timber_;
  float lines_;  // growth rings across the picture
  Field streaks_;
  Field bend_;
  Field to_knot_;  // distance to the next knot in patches of about 30 cm, at most 1
};

}  // namespace bulletnav::sim::materials
