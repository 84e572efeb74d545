// SPDX-License-Identifier: MIT
#include "benchmark/slam/plots/matrix_figure.h"

#include <cmath>
#include <cstddef>
#include <memory>

#include "benchmark/report/palette.h"

namespace bulletnav::bench {
namespace {

constexpr double kPanel = 300.0;
constexpr double kTitle = 34.0;
constexpr double kAxis = 24.0;
constexpr double kGap = 16.0;

/// Grey values in colours; what is nothing is dark.
sim::Image Colored(const sim::Image& grey) {
  sim::Image color(grey.width, grey.height, 3);
  const auto byte = [](double share) {
    return static_cast<std::uint8_t>(std::lround(255.0 * share));
  };
  for (std::size_t i = 0; i < grey.pixels.size(); ++i) {
    const Paint paint = TimeColor(grey.pixels[i] / 255.0);
    color.pixels[3 * i] = byte(paint.red);
    color.pixels[3 * i + 1] = byte(paint.green);
    color.pixels[3 * i + 2] = byte(paint.blue);
  }
  return color;
}

void DrawPanel(const std::string& title, const sim::Image& picture, double left, int frames,
               Canvas* canvas) {
  const Canvas::Point corner(left, kTitle);
  Eigen::Affine2d place = Eigen::Affine2d::Identity();
  place.translate(corner).scale(kPanel / picture.width);
  canvas->Picture(picture, place, false);
  const double middle = left + kPanel / 2.0;
  canvas->Text({middle, kTitle / 2.0}, title, {14.0, kInk, true, Align::kCenter, false, false});
  const double below = kTitle + kPanel + kAxis / 2.0;
  canvas->Text({left, below}, "0", {12.0, kInk, false, Align::kLeft, false, false});
  canvas->Text({middle, below}, "frame", {12.0, kInk, false, Align::kCenter, false, false});
  canvas->Text({left + kPanel, below}, std::to_string(frames - 1),
               {12.0, kInk, false, Align::kRight, false, false});
}

}  // namespace

Figure MatrixFigure(const std::vector<MatrixPanel>& panels, int frames) {
  auto drawn = std::make_shared<std::vector<MatrixPanel>>();
  for (const MatrixPanel& panel : panels) {
    if (panel.matrix.width > 0) drawn->push_back({panel.title, Colored(panel.matrix)});
  }
  Figure figure;
  figure.width = static_cast<int>(kGap + static_cast<double>(drawn->size()) * (kPanel + kGap));
  figure.height = static_cast<int>(kTitle + kPanel + kAxis);
  figure.draw = [drawn, frames](Canvas* canvas) {
    double left = kGap;
    for (const MatrixPanel& panel : *drawn) {
      DrawPanel(panel.title, panel.matrix, left, frames, canvas);
      left += kPanel + kGap;
    }
  };
  return figure;
}

}  // namespace bulletnav::bench
