// SPDX-License-Identifier: MIT
#include "benchmark/report/figure.h"

#include "sim/base/files.h"

namespace bulletnav::bench {

sim::Image ToImage(const Figure& figure, double scale) {
  Canvas canvas(figure.width, figure.height, kWhite, Canvas::Kind::kPixels, scale);
  figure.draw(&canvas);
  return canvas.ToImage();
}

std::string ToSvg(const Figure& figure) {
  Canvas canvas(figure.width, figure.height, kWhite, Canvas::Kind::kSvg);
  figure.draw(&canvas);
  return canvas.ToSvg();
}

void WriteFigure(const Figure& figure, const std::filesystem::path& stem) {
  // Not replace_extension: a name such as "random-0.5" would lose its end.
  sim::WriteFileAtomically(std::filesystem::path(stem) += ".svg", ToSvg(figure));
  sim::WritePng(std::filesystem::path(stem) += ".png", ToImage(figure));
}

}  // namespace bulletnav::bench
