// SPDX-License-Identifier: MIT
#include "sim/render/projection.h"

#include <cmath>

#include <fmt/core.h>

#include "sim/base/elementary.h"
#include "sim/base/error.h"
#include "sim/math/pose.h"

namespace bulletnav::sim {
namespace {

constexpr int kMinRows = 8;
constexpr int kMaxRows = 4096;
constexpr int kMinCols = 16;
constexpr int kMaxCols = 16384;
constexpr double kMinFov = 5.0;  // degrees
constexpr double kMaxFov = 150.0;

/// Columns of equal angle, clockwise from behind.
void FillCircle(RayGrid* grid, int cols) {
  for (int c = 0; c < cols; ++c) {
    const double clockwise = 2.0 * kPi * (c + 0.5) / cols - kPi;
    grid->x.push_back(static_cast<float>(Sin(clockwise)));
    grid->z.push_back(static_cast<float>(-Cos(clockwise)));
  }
}

/// Columns of four flat views; those of one view lie on a line at distance 1.
void FillCubeSides(RayGrid* grid, int cols) {
  const int side = cols / 4;
  for (int c = 0; c < cols; ++c) {
    const int view = c / side;
    const double centre = (view - 1.5) * 0.5 * kPi;
    const double across = 2.0 * (c % side + 0.5) / side - 1.0;
    grid->x.push_back(static_cast<float>(Sin(centre) + across * Cos(centre)));
    grid->z.push_back(static_cast<float>(-Cos(centre) + across * Sin(centre)));
  }
}

/// Rows linear in y, from +1 to -1. `column` is the width of a column at distance 1.
void FillLinearRows(RayGrid* grid, int rows, double column) {
  for (int r = 0; r < rows; ++r) {
    grid->y.push_back(static_cast<float>(1.0 - 2.0 * (r + 0.5) / rows));
    grid->area.push_back(static_cast<float>(column * 2.0 / rows));
  }
}

/// Rows of equal angle, from zenith to nadir.
void FillAngularRows(RayGrid* grid, int rows, double column) {
  for (int r = 0; r < rows; ++r) {
    const double elevation = 0.5 * kPi - kPi * (r + 0.5) / rows;
    const double cosine = Cos(elevation);
    grid->y.push_back(static_cast<float>(Tan(elevation)));
    grid->area.push_back(static_cast<float>(column * kPi / rows / (cosine * cosine)));
  }
}

void Fill(const PanoramaSpec& spec, RayGrid* grid) {
  const double angle = 2.0 * kPi / spec.cols;
  switch (spec.projection) {
    case Projection::kCylindrical:
      FillCircle(grid, spec.cols);
      FillLinearRows(grid, spec.rows, angle);
      return;
    case Projection::kEquirectangular:
      FillCircle(grid, spec.cols);
      FillAngularRows(grid, spec.rows, angle);
      return;
    case Projection::kCubeStrip:
      FillCubeSides(grid, spec.cols);
      FillLinearRows(grid, spec.rows, 8.0 / spec.cols);
      return;
  }
}

void Fill(const PinholeSpec& spec, RayGrid* grid) {
  const double width = 2.0 * spec.tan_x() / spec.cols;
  for (int c = 0; c < spec.cols; ++c) {
    grid->x.push_back(static_cast<float>(width * (c + 0.5) - spec.tan_x()));
    grid->z.push_back(-1.0f);
  }
  for (int r = 0; r < spec.rows; ++r) {
    grid->y.push_back(static_cast<float>(spec.tan_y() - width * (r + 0.5)));
    grid->area.push_back(static_cast<float>(width * width));
  }
  grid->pitch = DegToRad(spec.pitch_deg);
}

void CheckSize(const char* what, int rows, int cols) {
  if (rows < kMinRows || rows > kMaxRows || cols < kMinCols || cols > kMaxCols) {
    throw Error(fmt::format("a {} of {}x{} cannot be drawn; sizes go from 16x8 to 16384x4096", what,
                            cols, rows));
  }
}

}  // namespace

void PanoramaSpec::Validate() const {
  CheckSize("panorama", rows, cols);
  if (projection == Projection::kCubeStrip && cols % 4 != 0) {
    throw Error("the width of a cube strip must be a multiple of 4");
  }
  if (!(max_depth_m > 0.0f)) throw Error("max_depth_m must be positive");
}

double PinholeSpec::tan_x() const {
  return Tan(0.5 * DegToRad(hfov_deg));
}

void PinholeSpec::Validate() const {
  CheckSize("pinhole picture", rows, cols);
  if (!(hfov_deg >= kMinFov && hfov_deg <= kMaxFov)) {
    throw Error(fmt::format("hfov_deg is {}; a pinhole camera's field of view goes from {} to {}",
                            hfov_deg, kMinFov, kMaxFov));
  }
  const double upwards = 2.0 * RadToDeg(Atan(tan_y()));
  if (!(upwards >= kMinFov && upwards <= kMaxFov)) {
    throw Error(fmt::format(
        "hfov_deg {} in a picture of {}x{} sees {:.1f} degrees upwards; {} to {} can be drawn",
        hfov_deg, cols, rows, upwards, kMinFov, kMaxFov));
  }
  if (!(std::abs(pitch_deg) <= 90.0)) {
    throw Error(fmt::format("pitch_deg is {}; it goes from -90 (down) to 90 (up)", pitch_deg));
  }
  if (!(max_depth_m > 0.0f)) throw Error("max_depth_m must be positive");
}

PictureSize SizeOf(const CameraSpec& spec) {
  return std::visit(
      [](const auto& s) {
        return PictureSize{s.rows, s.cols};
      },
      spec);
}

float MaxDepthOf(const CameraSpec& spec) {
  return std::visit(
      [](const auto& s) {
        return s.max_depth_m;
      },
      spec);
}

RayGrid::RayGrid(const CameraSpec& spec) {
  std::visit(
      [this](const auto& s) {
        s.Validate();
        Fill(s, this);
      },
      spec);
}

Eigen::Vector3f RayGrid::Direction(std::size_t row, std::size_t col) const {
  const auto c = static_cast<float>(Cos(pitch));
  const auto s = static_cast<float>(Sin(pitch));
  return {x[col], y[row] * c - z[col] * s, y[row] * s + z[col] * c};
}

}  // namespace bulletnav::sim
