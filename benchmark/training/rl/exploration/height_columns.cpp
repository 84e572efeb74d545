// SPDX-License-Identifier: MIT
#include "benchmark/training/rl/exploration/height_columns.h"

#include <algorithm>
#include <cmath>

namespace bulletnav::bench {
namespace {

constexpr double kRim = 4.0;         // metres
constexpr float kApart = 0.02f;      // of points on a triangle
constexpr double kFloorBelow = 0.1;  // metres
constexpr int kRimCells = static_cast<int>(kRim / HeightColumns::kCell);

int PartsOf(const Eigen::Vector3f& edge) {
  return 1 + static_cast<int>(edge.norm() / kApart);
}

}  // namespace

HeightColumns::HeightColumns(const sim::SceneMesh& mesh, double floor) {
  const Eigen::AlignedBox3f box = mesh.Bounds();
  low_x_ = double{box.min().x()} - kRim;
  low_z_ = double{box.min().z()} - kRim;
  const auto cells = [](float from, float to) {
    return static_cast<int>(std::ceil((double{to} - double{from} + 2.0 * kRim) / kCell)) + 1;
  };
  width_ = cells(box.min().x(), box.max().x());
  depth_ = cells(box.min().z(), box.max().z());
  values_.assign(static_cast<std::size_t>(width_) * static_cast<std::size_t>(depth_), 0);
  for (const auto& triangle : mesh.triangles) {
    const Eigen::Vector3f& a = mesh.positions[triangle[0]];
    MarkTriangle(a, mesh.positions[triangle[1]] - a, mesh.positions[triangle[2]] - a, floor);
  }
}

void HeightColumns::MarkTriangle(const Eigen::Vector3f& a, const Eigen::Vector3f& u,
                                 const Eigen::Vector3f& v, double floor) {
  const float low = a.y() + std::min({0.0f, u.y(), v.y()});
  const float high = a.y() + std::max({0.0f, u.y(), v.y()});
  if (low > floor + kBits * kCell || high < floor - kFloorBelow) return;
  const int n = std::max(PartsOf(u), PartsOf(v));
  const float part = 1.0f / static_cast<float>(n);
  // The third edge may be longer than both; points lie between those of parallel lines.
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; i + j <= n; ++j) {
      Mark(a + u * (static_cast<float>(i) * part) + v * (static_cast<float>(j) * part), floor);
    }
  }
}

void HeightColumns::Mark(const Eigen::Vector3f& point, double floor) {
  const double height = double{point.y()} - floor;
  if (height < -kFloorBelow || height >= kBits * kCell) return;
  const int bit = std::max(0, static_cast<int>(std::floor(height / kCell)));
  const int x = static_cast<int>(AlongX(double{point.x()}));
  const int z = static_cast<int>(AlongZ(double{point.z()}));
  const std::size_t cell =
      static_cast<std::size_t>(z) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  values_[cell] |= std::uint32_t{1} << bit;
}

bool HeightColumns::IsInside(double along_x, double along_z) const {
  return along_x >= kRimCells && along_z >= kRimCells && along_x <= width_ - 1 - kRimCells &&
         along_z <= depth_ - 1 - kRimCells;
}

}  // namespace bulletnav::bench
