// SPDX-License-Identifier: MIT
#include "sim/render/kernels/sampling.h"

#include <algorithm>
#include <cmath>

#include "sim/base/check.h"
#include "sim/math/pose.h"

namespace bulletnav::sim {
namespace {

constexpr int kFixedOne = 256;  // KernelGrid's fixed point
constexpr int kRounding = 2;    // of the float arithmetic around a table, in fixed point

/// Clockwise angle from behind, in turns, of a diamond-angle position in [0, 4].
double TurnsOfDiamond(double p) {
  if (p <= 0.0) return 0.0;
  if (p >= 4.0) return 1.0;
  const double sine = p <= 1.0 ? -p : (p <= 3.0 ? p - 2.0 : 4.0 - p);
  const double cosine = p > 1.0 && p < 3.0 ? 1.0 - std::abs(sine) : std::abs(sine) - 1.0;
  return std::atan2(sine, cosine) / (2.0 * kPi) + 0.5;
}

/// Column position (0 at the left edge of the picture) of a heading.
double ColumnOfTurns(const PanoramaSpec& spec, double turns) {
  if (spec.projection != Projection::kCubeStrip) return turns * spec.cols;
  const double side = std::min(3.0, std::floor(turns * 4.0));
  const double off_centre = (turns * 4.0 - side - 0.5) * 0.5 * kPi;
  return (side + 0.5 + 0.5 * std::tan(off_centre)) * spec.cols / 4.0;
}

/// Row whose centre samples slope y.
double RowOfSlope(const PanoramaSpec& spec, double y) {
  const bool angular = spec.projection == Projection::kEquirectangular;
  const double from_top = angular ? 0.5 - std::atan(y) / kPi : 0.5 - 0.5 * y;
  return std::clamp(from_top * spec.rows - 0.5, -1.0, static_cast<double>(spec.rows));
}

/// The least shift, from `least` on, that fits `size` into `tiles`.
int TileShift(int size, int tiles, int least) {
  int shift = least;
  while (tiles << shift < size) ++shift;
  return shift;
}

}  // namespace

template <class Function>
Sampling::Table Sampling::Tabulate(int cells, const Function& f) {
  Table table;
  double largest_step = 0.0;
  for (int i = 0; i <= cells; ++i) {
    const double a = f(static_cast<double>(i) / cells);
    const double b = f(static_cast<double>(std::min(i + 1, cells)) / cells);
    table.least.push_back(static_cast<std::int32_t>(std::floor(std::min(a, b) * kFixedOne)) -
                          kRounding);
    largest_step = std::max(largest_step, std::abs(b - a));
  }
  table.slack = static_cast<std::int32_t>(std::ceil(largest_step * kFixedOne)) + 2 * kRounding + 1;
  return table;
}

Sampling::Sampling(const PanoramaSpec& spec) : spec_(spec), rays_(spec) {
  for (const float y : rays_.y) y_squared_.push_back(y * y);
  FillGrid();
  const auto stride = static_cast<std::size_t>(grid_.stride);
  x_.resize(stride);
  z_.resize(stride);
  xz_squared_.resize(stride);
  inverse_t_.resize(stride * static_cast<std::size_t>(spec.rows));
  id_.resize(inverse_t_.size());
  hits_ = {inverse_t_.data(), id_.data()};
}

void Sampling::FillGrid() {
  const int column_cells = std::max(16384, 32 * spec_.cols);
  const int row_cells = std::max(8192, 64 * spec_.rows);
  columns_ = Tabulate(column_cells, [&](double p) {
    return ColumnOfTurns(spec_, TurnsOfDiamond(4.0 * p));
  });
  rows_ = Tabulate(row_cells, [&](double p) {
    const double s = 2.0 * p - 1.0;
    return RowOfSlope(spec_, s / std::max(1e-9, 1.0 - std::abs(s)));
  });
  float xz_max = 1.0f;
  for (std::size_t c = 0; c < rays_.x.size(); ++c) {
    xz_max = std::max(xz_max, std::hypot(rays_.x[c], rays_.z[c]));
  }
  grid_ = {
      .rows = spec_.rows,
      .cols = spec_.cols,
      .stride = (spec_.cols + kRowPadding - 1) / kRowPadding * kRowPadding,
      .tile_row_shift = TileShift(spec_.rows, kTileRows, 2),
      .tile_column_shift = TileShift(spec_.cols, kTileColumns, 4),
      .y = rays_.y.data(),
      .y_squared = y_squared_.data(),
      .area = rays_.area.data(),
      .xz_max = xz_max,
      .max_depth = spec_.max_depth_m,
      .column_of_angle = columns_.least.data(),
      .row_of_slope = rows_.least.data(),
      .angle_scale = static_cast<float>(column_cells) / 4.0f,
      .slope_scale = static_cast<float>(row_cells) / 2.0f,
      .column_slack = columns_.slack,
      .row_slack = rows_.slack,
  };
}

KernelFrame Sampling::Frame(const CameraPose& camera) {
  BULLETNAV_CHECK(camera.position.allFinite() && std::isfinite(camera.yaw));
  const float c = std::cos(camera.yaw);
  const float s = std::sin(camera.yaw);
  for (std::size_t i = 0; i < rays_.x.size(); ++i) {
    x_[i] = rays_.x[i] * c + rays_.z[i] * s;
    z_[i] = rays_.z[i] * c - rays_.x[i] * s;
    xz_squared_[i] = rays_.x[i] * rays_.x[i] + rays_.z[i] * rays_.z[i];
  }
  const Eigen::Vector3f& p = camera.position;
  return {{p.x(), p.y(), p.z()}, c, s, x_.data(), z_.data(), xz_squared_.data()};
}

PanoramaSlices::PanoramaSlices(const PanoramaSpec& spec, std::size_t cameras,
                               std::span<std::uint8_t> color, std::span<float> depth)
    : pixels_(spec.pixels()), color_(color), depth_(depth) {
  BULLETNAV_CHECK(color.empty() || color.size() == 3 * pixels_ * cameras);
  BULLETNAV_CHECK(depth.empty() || depth.size() == pixels_ * cameras);
}

}  // namespace bulletnav::sim
