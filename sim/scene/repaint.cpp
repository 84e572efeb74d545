// SPDX-License-Identifier: MIT
#include "sim/scene/repaint.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/base/check.h"
#include "sim/base/error.h"
#include "sim/image/hue.h"

namespace bulletnav::sim {
namespace {

constexpr double kLightest = 255.0;
constexpr double kDarkestPaint = 0.25;  // value (of hue, saturation, value)
constexpr double kLeastOfPaint = 0.5;   // share that paint has in what is seen
constexpr double kMostSaturated = 0.8;
constexpr double kLeastDetail = 1.0;  // grey that details are measured against, at least

using Color = std::array<double, 3>;

/// A colour and how much of it covers what was there.
struct Paint {
  Color color;
  double share;
};

Paint DrawPaint(Rng* rng) {
  const double hue = rng->Uniform();
  const double pale = rng->Uniform();
  const double value = rng->Uniform(kDarkestPaint, 1.0);
  return {FromHue(hue, kMostSaturated * pale * pale, value), rng->Uniform(kLeastOfPaint, 1.0)};
}

double GreyOf(const std::uint8_t* rgb) {
  return (rgb[0] + rgb[1] + rgb[2]) / 3.0;
}

/// `detail`: how much lighter the pixel is than its surroundings, 1 for as light.
void Cover(const Paint& paint, double detail, std::uint8_t* rgb) {
  for (std::size_t c = 0; c < paint.color.size(); ++c) {
    const double painted = kLightest * paint.color[c] * detail;
    const double seen = paint.share * painted + (1.0 - paint.share) * rgb[c];
    rgb[c] = static_cast<std::uint8_t>(std::lround(std::clamp(seen, 0.0, kLightest)));
  }
}

void Cover(const Paint& paint, Image* image) {
  std::vector<std::uint8_t>& pixels = image->pixels;
  double sum = 0.0;
  for (std::size_t i = 0; i < pixels.size(); i += 4) sum += GreyOf(&pixels[i]);
  const std::size_t count = std::max<std::size_t>(1, pixels.size() / 4);
  const double mean = std::max(kLeastDetail, sum / static_cast<double>(count));
  for (std::size_t i = 0; i < pixels.size(); i += 4) {
    Cover(paint, GreyOf(&pixels[i]) / mean, &pixels[i]);
  }
}

}  // namespace

void Repaint::Validate() const {
  for (const double share : {recolored, exchanged}) {
    if (!(share >= 0.0 && share <= 1.0)) {
      throw Error("recolored and exchanged are shares, 0 to 1");
    }
  }
}

void ApplyRepaint(const Repaint& repaint, SceneMesh* mesh) {
  repaint.Validate();
  const Rng rng(repaint.seed, "repaint");
  if (repaint.exchanged > 0.0) ExchangeTextures(repaint.exchanged, rng, mesh);
  if (repaint.recolored > 0.0) RecolorMaterials(repaint.recolored, rng, mesh);
}

void RecolorMaterials(double share, const Rng& rng, SceneMesh* mesh) {
  BULLETNAV_CHECK(share >= 0.0 && share <= 1.0);
  for (std::size_t i = 0; i < mesh->textures.size(); ++i) {
    Rng own = rng.Fork("texture", i);
    if (own.Chance(share)) Cover(DrawPaint(&own), &mesh->textures[i].image);
  }
  for (std::size_t i = 0; i < mesh->materials.size(); ++i) {
    Material& material = mesh->materials[i];
    Rng own = rng.Fork("material", i);
    if (material.texture >= 0 || !own.Chance(share)) continue;
    Cover(DrawPaint(&own), 1.0, material.base_color.data());
  }
}

void ExchangeTextures(double share, const Rng& rng, SceneMesh* mesh) {
  BULLETNAV_CHECK(share >= 0.0 && share <= 1.0);
  Rng own = rng.Fork("exchange");
  std::vector<std::size_t> places;
  std::vector<int> textures;
  for (std::size_t i = 0; i < mesh->materials.size(); ++i) {
    if (mesh->materials[i].texture < 0 || !own.Chance(share)) continue;
    places.push_back(i);
    textures.push_back(mesh->materials[i].texture);
  }
  own.Shuffle(textures);
  for (std::size_t i = 0; i < places.size(); ++i) mesh->materials[places[i]].texture = textures[i];
}

}  // namespace bulletnav::sim
