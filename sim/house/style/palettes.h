// SPDX-License-Identifier: MIT
#pragma once
#include "sim/house/style/style_book.h"

namespace bulletnav::sim::style {

/// Draws what the furniture of a room of some type is made of.
Palette DrawPalette(const StyleBook& book, RoomType type, Rng* rng);

/// Cheerful paints for kids' rooms, the same in all styles.
const std::vector<Rgb8>& KidsColors();

}  // namespace bulletnav::sim::style
