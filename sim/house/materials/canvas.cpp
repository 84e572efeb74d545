// SPDX-License-Identifier: MIT
#include "sim/house/materials/canvas.h"

namespace bulletnav::sim::materials {

Color Canvas::At(Point p) const {
  int x = Floor(p.x * static_cast<float>(side_));
  int y = Floor(p.y * static_cast<float>(side_));
  if (edge_ == Edge::kClip) {
    x = std::clamp(x, 0, side_ - 1);
    y = std::clamp(y, 0, side_ - 1);
  }
  const int mask = side_ - 1;
  return pixels_[static_cast<std::size_t>(y & mask) * static_cast<std::size_t>(side_) +
                 static_cast<std::size_t>(x & mask)];
}

Image Canvas::Finish() const {
  const auto byte = [](float v) {
    return static_cast<std::uint8_t>(Round(std::clamp(v, 0.0f, 255.0f)));
  };
  Image image(side_, side_, 4);
  std::uint8_t* out = image.pixels.data();
  for (const Color& c : pixels_) {
    *out++ = byte(c.r);
    *out++ = byte(c.g);
    *out++ = byte(c.b);
    *out++ = 255;
  }
  return image;
}

}  // namespace bulletnav::sim::materials
