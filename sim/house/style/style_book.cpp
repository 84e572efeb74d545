// SPDX-License-Identifier: MIT
#include "sim/house/style/style_book.h"

#include <array>

namespace bulletnav::sim::style {

const StyleBook& BookOf(StyleKind kind) {
  static const std::array<StyleBook, 8> books = {
      ScandinavianBook(), ModernBook(),        RusticBook(),  ClassicBook(),
      IndustrialBook(),   MediterraneanBook(), CountryBook(), RetroBook()};
  return books[static_cast<std::size_t>(kind)];
}

}  // namespace bulletnav::sim::style
