// SPDX-License-Identifier: MIT
// One shelf of books, seen from the front; goes on over the seam at its sides.
#include "sim/house/materials/brushwork.h"
#include "sim/house/materials/families.h"

namespace bulletnav::sim::materials {
namespace {

constexpr Color kShadow = Hex(0x4b3c30);  // the shelf's back

struct Library {
  std::span<const Color> bindings;
  float low = 0.62f;  // heights of books, in fractions of the shelf's
  float high = 0.95f;
  float gilding = 0.2f;  // chance of gold bands
  Color title;
};

/// A book's back: rounded to the sides, with a title and sometimes bands.
void PaintSpine(Canvas* canvas, const Rect& spine, const Library& library, Rng* rng) {
  const float width = spine.high.x - spine.low.x;
  const float height = spine.high.y - spine.low.y;
  const float wear = Between(*rng, 0.9f, 1.08f);
  const Color binding = OneOf(*rng, library.bindings) * wear;
  canvas->Paint(spine, [&](Point p) {
    const float across = (p.x - spine.low.x) / width;
    return binding * (1.06f - 0.5f * std::abs(across - 0.42f) * std::abs(across - 0.42f) * 3.0f);
  });
  const auto band = [&](float y, float thick, Color color) {
    const float top = spine.low.y + y * height;
    canvas->Paint(
        Rect{{spine.low.x + 0.06f * width, top}, {spine.high.x - 0.06f * width, top + thick}},
        color);
  };
  const Color ink = rng->Chance(library.gilding) ? Hex(0xd3a84e) : library.title;
  if (rng->Chance(library.gilding)) {
    for (const float y : {0.06f, 0.2f, 0.76f, 0.92f}) band(y, 0.012f, Hex(0xcfa34a));
  } else if (rng->Chance(0.5)) {
    band(0.05f, Between(*rng, 0.02f, 0.06f), binding * 0.72f);
    band(0.86f, Between(*rng, 0.02f, 0.05f), binding * 0.72f);
  }
  if (rng->Chance(0.25)) {
    band(0.25f, 0.3f * height, Mix(binding, Hex(0xf3ecdd), 0.75f));
  }
  // The title runs down the spine.
  const float middle = spine.low.x + 0.5f * width;
  float y = spine.low.y + 0.28f * height;
  while (y < spine.low.y + 0.66f * height) {
    const float word = Between(*rng, 0.04f, 0.12f) * height;
    canvas->Paint(Stroke{{middle, y}, {middle, y + word}, 0.26f * width}, ink, {0.75f, 0.0f});
    y += word + 0.035f;
  }
  canvas->Paint(Rect{{spine.high.x - 0.003f, spine.low.y}, {spine.high.x + 0.002f, spine.high.y}},
                kShadow * 0.6f, {0.8f, 0.0f});
}

Image Shelf(const Library& library, std::string_view name) {
  Canvas canvas(kShadow);
  canvas.Shade([](Point p) {
    return kShadow * Mix(0.6f, 1.0f, Smooth(0.0f, 0.3f, p.y));
  });
  Rng rng(0, name);
  // Widths first, so that they can be made to fill the shelf exactly.
  std::vector<float> widths;
  float total = 0.0f;
  while (total < 1.0f) {
    widths.push_back(Between(rng, 0.022f, 0.056f));
    total += widths.back();
  }
  float x = 0.0f;
  float height = Between(rng, library.low, library.high);
  for (const float width : widths) {
    // Neighbours are often volumes of one series.
    if (rng.Chance(0.7)) height = Between(rng, library.low, library.high);
    const float right = x + width / total;
    PaintSpine(&canvas, {{x, 1.0f - height}, {right, 0.995f}}, library, &rng);
    x = right;
  }
  return canvas.Finish();
}

Image Books() {
  constexpr Color kBindings[] = {Hex(0xb9473f), Hex(0x3f6fa0), Hex(0xe0c15c), Hex(0x4f8a68),
                                 Hex(0xe9e2d2), Hex(0x2f3f57), Hex(0xd98a4a), Hex(0x7c5a86),
                                 Hex(0x9fb8c4), Hex(0xf2ede2), Hex(0x8a3a46), Hex(0x5b6f4a),
                                 Hex(0x333338), Hex(0xcf8f94)};
  return Shelf({kBindings, 0.62f, 0.95f, 0.08f, Hex(0xf5efe0)}, "book_spines");
}

/// An old library, bound in leather.
Image DarkBooks() {
  constexpr Color kBindings[] = {Hex(0x6d3b2c), Hex(0x552b2b), Hex(0x3b4a3a), Hex(0x34405a),
                                 Hex(0x7d5535), Hex(0x4a352a), Hex(0x8c6a45)};
  return Shelf({kBindings, 0.76f, 0.92f, 0.75f, Hex(0xc8a765)}, "book_spines_dark");
}

constexpr MaterialRecipe kRecipes[] = {
    {"book_spines", MaterialFamily::kOther, 1.0f, Books, false},
    {"book_spines_dark", MaterialFamily::kOther, 1.0f, DarkBooks, false},
};

}  // namespace

std::span<const MaterialRecipe> BookShelves() {
  return kRecipes;
}

}  // namespace bulletnav::sim::materials
