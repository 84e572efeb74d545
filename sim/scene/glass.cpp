// SPDX-License-Identifier: MIT
#include "sim/scene/glass.h"

#include <algorithm>
#include <array>
#include <span>
#include <string>

namespace bulletnav::sim {
namespace {

using Word = std::string_view;

constexpr Word kMark = "(see-through)";
constexpr Word kPictureBehindAWindow = "_view";
constexpr std::array kShiny = {Word("window"), Word("glass"), Word("mirror"), Word("screen"),
                               Word("metal"),  Word("steel"), Word("chrome")};
constexpr std::array kGlass = {Word("window"), Word("glass"),  Word("glazing"),
                               Word("plexi"),  Word("mirror"), Word("screen")};
constexpr std::array kBesides = {Word("frame"),   Word("sill"),  Word("blind"),   Word("shutter"),
                                 Word("curtain"), Word("trim"),  Word("handle"),  Word("bezel"),
                                 Word("fiber"),   Word("fibre"), Word("project"), Word("wood"),
                                 Word("metal"),   Word("steel"), Word("plastic")};

std::string InLowerCase(std::string_view name) {
  std::string lower(name);
  for (char& c : lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return lower;
}

bool HasAnyOf(std::span<const Word> words, const std::string& name) {
  return std::any_of(words.begin(), words.end(), [&](Word word) {
    return name.find(word) != std::string::npos;
  });
}

}  // namespace

bool IsShiny(std::string_view material) {
  return HasAnyOf(kShiny, InLowerCase(material));
}

bool IsGlass(std::string_view material) {
  if (material.ends_with(kMark) || material.ends_with(kPictureBehindAWindow)) return true;
  const std::string name = InLowerCase(material);
  return HasAnyOf(kGlass, name) && !HasAnyOf(kBesides, name);
}

bool IsSeeThrough(double opacity) {
  constexpr double kLeast = 0.02;
  constexpr double kMost = 0.8;
  return opacity > kLeast && opacity < kMost;
}

void MarkSeeThrough(Material* material) {
  if (material->name.ends_with(kMark)) return;
  if (!material->name.empty()) material->name += ' ';
  material->name += kMark;
}

}  // namespace bulletnav::sim
