// SPDX-License-Identifier: MIT
#include "sim/render/kernels/sampling.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <fmt/core.h>

#include "sim/base/elementary.h"
#include "sim/base/error.h"
#include "sim/math/pose.h"
#include "sim/math/rotation.h"

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
  return Atan2(sine, cosine) / (2.0 * kPi) + 0.5;
}

/// Where headings and slopes fall in a panorama.
class PanoramaPlaces {
 public:
  explicit PanoramaPlaces(const PanoramaSpec& spec) : spec_(spec) {}

  /// Columns around all headings. Opposite headings must be half of them apart.
  int circle() const { return spec_.cols; }

  /// Column position (0 at the left edge of the picture) of a heading, rising.
  double ColumnOfTurns(double turns) const {
    if (spec_.projection != Projection::kCubeStrip) return turns * spec_.cols;
    const double side = std::min(3.0, std::floor(turns * 4.0));
    const double off_centre = (turns * 4.0 - side - 0.5) * 0.5 * kPi;
    return (side + 0.5 + 0.5 * Tan(off_centre)) * spec_.cols / 4.0;
  }

  /// Row whose centre samples slope y.
  double RowOfSlope(double y) const {
    const bool angular = spec_.projection == Projection::kEquirectangular;
    const double from_top = angular ? 0.5 - Atan(y) / kPi : 0.5 - 0.5 * y;
    return from_top * spec_.rows - 0.5;
  }

 private:
  const PanoramaSpec& spec_;
};

/// The same for a pinhole picture. The headings outside its field of view have columns too: those
/// behind are spread like those ahead, those to the sides evenly.
class PinholePlaces {
 public:
  explicit PinholePlaces(const PinholeSpec& spec) : spec_(spec), half_angle_(Atan(spec.tan_x())) {
    const double alike = spec.cols * (0.5 * kPi - half_angle_) / spec.tan_x();
    side_ = std::clamp(static_cast<int>(alike), kLeastSide, 2 * spec.cols);
  }

  int circle() const { return 2 * (spec_.cols + side_); }

  double ColumnOfTurns(double turns) const {
    const double angle = 2.0 * kPi * (turns - 0.5);  // clockwise from ahead
    const double half_circle = 0.5 * circle();
    const double middle = 0.5 * spec_.cols;
    if (angle > 0.5 * kPi) return middle + half_circle + OffCentre(angle - kPi);
    if (angle < -0.5 * kPi) return middle - half_circle + OffCentre(angle + kPi);
    return middle + OffCentre(angle);
  }

  double RowOfSlope(double y) const { return (0.5 - 0.5 * y / spec_.tan_y()) * spec_.rows - 0.5; }

 private:
  static constexpr int kLeastSide = 16;

  double OffCentre(double angle) const {
    const double size = std::abs(angle);
    if (size <= half_angle_) return 0.5 * spec_.cols * Tan(angle) / spec_.tan_x();
    const double beyond = (size - half_angle_) / (0.5 * kPi - half_angle_);
    return std::copysign(0.5 * (spec_.cols + beyond * side_), angle);
  }

  const PinholeSpec& spec_;
  double half_angle_;
  int side_ = 0;  // columns to each side of the picture, up to those behind
};

PanoramaPlaces PlacesOf(const PanoramaSpec& spec) {
  return PanoramaPlaces(spec);
}
PinholePlaces PlacesOf(const PinholeSpec& spec) {
  return PinholePlaces(spec);
}

/// The turn that makes a camera of this yaw and pitch level: tilt * world = level.
Eigen::Matrix3f TiltOf(double yaw, double pitch) {
  const Eigen::Vector3d right(Cos(yaw), 0.0, -Sin(yaw));
  return RotationAbout(right, -pitch).cast<float>();
}

/// The least shift, from `least` on, that fits `size` into `tiles`.
int TileShift(int size, int tiles, int least) {
  int shift = least;
  while (tiles << shift < size) ++shift;
  return shift;
}

/// What is told of the triangle that each pixel shows, 0 where there is none.
template <class T, class OfTriangle>
void WriteOfHits(const Sampling& sampling, T* out, const OfTriangle& told) {
  const KernelGrid& grid = sampling.grid();
  for (int row = 0; row < grid.rows; ++row) {
    const std::int32_t* ids = sampling.hits().id + std::int64_t{row} * grid.stride;
    for (int col = 0; col < grid.cols; ++col) {
      *out++ = ids[col] >= 0 ? told(static_cast<std::size_t>(ids[col])) : T{0};
    }
  }
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

Sampling::Sampling(const CameraSpec& spec) : spec_(spec), rays_(spec) {
  for (const float y : rays_.y) y_squared_.push_back(y * y);
  FillGrid();
  const auto stride = static_cast<std::size_t>(grid_.stride);
  x_.resize(stride);
  z_.resize(stride);
  xz_squared_.resize(stride);
  inverse_t_.resize(stride * static_cast<std::size_t>(grid_.rows));
  id_.resize(inverse_t_.size());
  hits_ = {inverse_t_.data(), id_.data()};
}

template <class Places>
void Sampling::FillTables(const Places& places) {
  const PictureSize size = SizeOf(spec_);
  const int column_cells = std::max(16384, 32 * size.cols);
  const int row_cells = std::max(8192, 64 * size.rows);
  columns_ = Tabulate(column_cells, [&](double p) {
    return places.ColumnOfTurns(TurnsOfDiamond(4.0 * p));
  });
  rows_ = Tabulate(row_cells, [&](double p) {
    const double s = 2.0 * p - 1.0;
    const double row = places.RowOfSlope(s / std::max(1e-9, 1.0 - std::abs(s)));
    return std::clamp(row, -1.0, static_cast<double>(size.rows));
  });
  grid_.circle = places.circle();
  grid_.angle_scale = static_cast<float>(column_cells) / 4.0f;
  grid_.slope_scale = static_cast<float>(row_cells) / 2.0f;
}

float Sampling::HalfPixel() const {
  float least = 1.0f;
  for (std::size_t r = 1; r < rays_.y.size(); ++r) {
    least = std::min(least, std::abs(rays_.y[r] - rays_.y[r - 1]));
  }
  for (std::size_t c = 1; c < rays_.x.size(); ++c) {
    least = std::min(least, std::hypot(rays_.x[c] - rays_.x[c - 1], rays_.z[c] - rays_.z[c - 1]));
  }
  return 0.5f * least;
}

void Sampling::FillGrid() {
  std::visit(
      [this](const auto& spec) {
        FillTables(PlacesOf(spec));
      },
      spec_);
  const PictureSize size = SizeOf(spec_);
  float xz_max = 1.0f;
  for (std::size_t c = 0; c < rays_.x.size(); ++c) {
    xz_max = std::max(xz_max, std::hypot(rays_.x[c], rays_.z[c]));
  }
  grid_.rows = size.rows;
  grid_.cols = size.cols;
  grid_.stride = (size.cols + kRowPadding - 1) / kRowPadding * kRowPadding;
  grid_.tile_row_shift = TileShift(size.rows, kTileRows, 2);
  grid_.tile_column_shift = TileShift(size.cols, kTileColumns, 4);
  grid_.y = rays_.y.data();
  grid_.y_squared = y_squared_.data();
  grid_.area = rays_.area.data();
  grid_.xz_max = xz_max;
  grid_.half_pixel = HalfPixel();
  grid_.max_depth = MaxDepthOf(spec_);
  grid_.column_of_angle = columns_.least.data();
  grid_.row_of_slope = rows_.least.data();
  grid_.column_slack = columns_.slack;
  grid_.row_slack = rows_.slack;
}

KernelFrame Sampling::Frame(const CameraPose& camera) {
  const float c = Cos(camera.yaw);
  const float s = Sin(camera.yaw);
  for (std::size_t i = 0; i < rays_.x.size(); ++i) {
    x_[i] = rays_.x[i] * c + rays_.z[i] * s;
    z_[i] = rays_.z[i] * c - rays_.x[i] * s;
    xz_squared_[i] = rays_.x[i] * rays_.x[i] + rays_.z[i] * rays_.z[i];
  }
  const Eigen::Vector3f& p = camera.position;
  KernelFrame frame = {.origin = {p.x(), p.y(), p.z()},
                       .cos_yaw = c,
                       .sin_yaw = s,
                       .x = x_.data(),
                       .z = z_.data(),
                       .xz_squared = xz_squared_.data(),
                       .is_level = rays_.pitch == 0.0,
                       .tilt = {}};
  const Eigen::Matrix3f tilt = TiltOf(camera.yaw, rays_.pitch);
  for (int row = 0; row < 3; ++row) {
    for (int axis = 0; axis < 3; ++axis) frame.tilt[row][axis] = tilt(row, axis);
  }
  return frame;
}

PictureSlices::PictureSlices(const CameraSpec& spec, std::span<const CameraPose> cameras,
                             const PictureMemory& out)
    : pixels_(SizeOf(spec).pixels()),
      color_(out.color),
      depth_(out.depth),
      objects_(out.objects),
      glass_(out.glass) {
  for (const CameraPose& camera : cameras) {
    if (!camera.position.allFinite() || !std::isfinite(camera.yaw)) {
      throw Error("Render: a camera's position or yaw is not a finite number");
    }
  }
  const auto check = [](const char* name, std::size_t size, std::size_t wanted) {
    if (size == 0 || size == wanted) return;
    throw Error(fmt::format("Render: the span for {} has {} elements; it must be empty or have {}",
                            name, size, wanted));
  };
  const std::size_t all = pixels_ * cameras.size();
  check("colour", out.color.size(), 3 * all);
  check("depth", out.depth.size(), all);
  check("objects", out.objects.size(), all);
  check("glass", out.glass.size(), all);
}

void PictureSlices::WriteSeen(std::size_t i, const Sampling& sampling,
                              std::span<const std::uint32_t> objects,
                              std::span<const TriangleShading> shading) const {
  if (!objects_.empty()) {
    WriteOfHits(sampling, &objects_[pixels_ * i], [&](std::size_t triangle) {
      return objects.empty() ? 0 : static_cast<std::int32_t>(objects[triangle]);
    });
  }
  if (!glass_.empty()) {
    WriteOfHits(sampling, &glass_[pixels_ * i], [&](std::size_t triangle) {
      return static_cast<std::uint8_t>(shading[triangle].glass > 0.0f ? 1 : 0);
    });
  }
}

}  // namespace bulletnav::sim
