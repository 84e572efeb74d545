// SPDX-License-Identifier: MIT
// A political map of the world, its coasts simplified to a few dozen points.
#include "sim/house/materials/families.h"
#include "sim/house/materials/noise.h"
#include "sim/house/materials/shapes.h"

namespace bulletnav::sim::materials {
namespace {

/// Degrees east and north.
struct Degrees {
  float east;
  float north;
};

constexpr Degrees kNorthAmerica[] = {
    {-166, 66}, {-156, 71}, {-128, 70}, {-108, 68}, {-95, 72},  {-82, 69},  {-86, 66},  {-94, 60},
    {-88, 56},  {-80, 52},  {-78, 60},  {-66, 59},  {-56, 52},  {-65, 46},  {-70, 43},  {-76, 36},
    {-81, 31},  {-80, 26},  {-83, 30},  {-94, 30},  {-98, 24},  {-95, 18},  {-87, 21},  {-88, 16},
    {-83, 14},  {-82, 9},   {-78, 8},   {-86, 12},  {-95, 15},  {-105, 20}, {-110, 27}, {-117, 32},
    {-124, 42}, {-124, 49}, {-135, 58}, {-152, 59}, {-163, 55}, {-158, 59}, {-166, 62}};
constexpr Degrees kGreenland[] = {{-68, 77}, {-55, 82}, {-30, 83}, {-18, 78},
                                  {-24, 70}, {-42, 60}, {-52, 66}, {-56, 74}};
constexpr Degrees kSouthAmerica[] = {{-79, 8},   {-72, 12},  {-60, 9},   {-50, 1},   {-36, -6},
                                     {-39, -16}, {-48, -26}, {-54, -34}, {-62, -40}, {-66, -46},
                                     {-69, -52}, {-73, -52}, {-74, -44}, {-71, -30}, {-71, -18},
                                     {-77, -12}, {-81, -5},  {-79, 2}};
constexpr Degrees kAfrica[] = {{-6, 36},  {10, 37},  {20, 32},  {32, 31},  {36, 22},
                               {43, 12},  {51, 11},  {42, -2},  {40, -12}, {35, -20},
                               {32, -28}, {26, -34}, {18, -34}, {13, -22}, {12, -8},
                               {9, 3},    {-8, 5},   {-17, 14}, {-13, 27}};
constexpr Degrees kEurasia[] = {
    {-9, 38},  {-9, 44},  {-1, 45},  {-4, 48},  {4, 52},   {9, 57},   {12, 54},  {20, 55},
    {29, 60},  {22, 60},  {24, 65},  {17, 61},  {16, 56},  {11, 59},  {5, 60},   {14, 68},
    {28, 71},  {42, 67},  {60, 69},  {80, 73},  {104, 77}, {130, 72}, {160, 70}, {179, 68},
    {178, 63}, {163, 60}, {157, 52}, {155, 58}, {141, 58}, {140, 50}, {129, 42}, {127, 35},
    {122, 40}, {120, 35}, {121, 29}, {112, 21}, {106, 18}, {108, 11}, {103, 12}, {102, 5},
    {98, 12},  {94, 18},  {89, 22},  {80, 14},  {77, 8},   {72, 20},  {62, 25},  {52, 28},
    {58, 23},  {52, 16},  {44, 13},  {36, 27},  {35, 36},  {27, 37},  {24, 41},  {22, 37},
    {14, 45},  {18, 40},  {15, 38},  {9, 44},   {2, 41},   {-3, 36}};
constexpr Degrees kAustralia[] = {{114, -22}, {122, -18}, {130, -12}, {137, -15},
                                  {142, -11}, {147, -20}, {153, -27}, {149, -38},
                                  {140, -38}, {131, -32}, {117, -35}};
constexpr Degrees kBritain[] = {{-5, 50}, {1, 51}, {-2, 56}, {-4, 59}, {-6, 56}, {-3, 53}};
constexpr Degrees kIceland[] = {{-24, 65}, {-16, 67}, {-14, 65}, {-20, 63}};
constexpr Degrees kJapan[] = {{131, 32}, {136, 34}, {140, 35}, {142, 40},
                              {145, 44}, {141, 45}, {139, 39}, {133, 36}};
constexpr Degrees kMadagascar[] = {{44, -17}, {49, -12}, {50, -16}, {47, -25}, {44, -24}};
constexpr Degrees kSumatra[] = {{95, 5}, {104, -2}, {106, -6}, {114, -8}, {105, -7}, {100, -1}};
constexpr Degrees kBorneo[] = {{109, 1}, {117, 7}, {118, 1}, {115, -4}, {110, -2}};
constexpr Degrees kNewGuinea[] = {{131, -1}, {141, -3}, {150, -9}, {143, -9}, {138, -8}};
constexpr Degrees kNewZealand[] = {{173, -35}, {178, -38}, {174, -42},
                                   {168, -47}, {167, -45}, {173, -40}};
constexpr Degrees kPhilippines[] = {{120, 18}, {124, 13}, {126, 7}, {122, 8}, {121, 13}};

/// Equirectangular, from 60 degrees south to 85 north, inside a margin.
Point OnPaper(Degrees d) {
  return {0.04f + 0.92f * (d.east + 180.0f) / 360.0f, 0.06f + 0.88f * (85.0f - d.north) / 145.0f};
}

Image WorldMap() {
  constexpr Color kCountries[] = {Hex(0xf0d58c), Hex(0xe6a98a), Hex(0xb9d49a), Hex(0xd8b3cf),
                                  Hex(0xf2c0a6), Hex(0xa9cdb6), Hex(0xeee3a9)};
  Canvas canvas(Hex(0xf5f0e2), Edge::kClip);
  canvas.Paint(Rect{{0.03f, 0.04f}, {0.97f, 0.96f}}, Hex(0x8a7b66));
  canvas.Paint(Rect{{0.036f, 0.048f}, {0.964f, 0.952f}}, Hex(0xaed3e6));
  for (int i = 0; i <= 12; ++i) {
    const float x = OnPaper({-180.0f + 30.0f * static_cast<float>(i), 0.0f}).x;
    canvas.Paint(Stroke{{x, 0.05f}, {x, 0.95f}, 0.001f}, Hex(0x8fbbd3));
  }
  for (int i = 0; i < 6; ++i) {
    const float y = OnPaper({0.0f, -45.0f + 22.5f * static_cast<float>(i)}).y;
    canvas.Paint(Stroke{{0.04f, y}, {0.96f, y}, 0.001f}, Hex(0x8fbbd3));
  }
  // Countries are cells of scattered capitals.
  const auto country = [&](Point p) {
    const Point bent = p + Point{Noise(p, {24, 24, 1}), Noise(p, {24, 24, 2})} * 0.012f;
    const Nearest capital = Scatter(bent, {17, 15, 5});
    const float border = Smooth(0.06f, 0.02f, capital.second - capital.first);
    return Mix(kCountries[capital.id % std::size(kCountries)], Hex(0x9a8a72), 0.7f * border);
  };
  const std::span<const Degrees> lands[] = {kNorthAmerica, kGreenland,  kSouthAmerica, kAfrica,
                                            kEurasia,      kAustralia,  kBritain,      kIceland,
                                            kJapan,        kMadagascar, kSumatra,      kBorneo,
                                            kNewGuinea,    kNewZealand, kPhilippines};
  for (const auto& land : lands) {
    std::vector<Point> coast;
    for (const Degrees& d : land) coast.push_back(OnPaper(d));
    const Polygon outline(coast);
    // Shallow water along the coast.
    for (std::size_t i = 0; i < coast.size(); ++i) {
      const Stroke shore = {coast[i], coast[(i + 1) % coast.size()], 0.008f};
      canvas.Paint(shore, Hex(0x86b7d2), {0.8f, 0.012f});
    }
    canvas.Paint(outline, country);
  }
  return canvas.Finish();
}

constexpr MaterialRecipe kRecipes[] = {
    {"world_map", MaterialFamily::kOther, 1.0f, WorldMap, false},
};

}  // namespace

std::span<const MaterialRecipe> Maps() {
  return kRecipes;
}

}  // namespace bulletnav::sim::materials
