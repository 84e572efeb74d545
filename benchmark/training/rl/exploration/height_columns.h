// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim/scene/mesh.h"

namespace bulletnav::bench {

/// Which heights above a floor are occupied over each cell of it: a scene as a map simulator sees
/// it. Cells are squares of 5 cm of the world's x and z. Bit 0 of a column: there is floor, within
/// 10 cm below and 5 cm above; bit b: something is from b * 5 cm to (b + 1) * 5 cm above it, up to
/// 1.5 m. A rim of 4 m around the scene is empty.
class HeightColumns {
 public:
  static constexpr double kCell = 0.05;
  static constexpr int kBits = 30;

  /// `floor`: its height in the world. Cost: some 20 ns for each 4 cm2 of surface.
  HeightColumns(const sim::SceneMesh& mesh, double floor);

  int width() const { return width_; }
  int depth() const { return depth_; }
  /// In cells from the corner of least x and z.
  double AlongX(double x) const { return (x - low_x_) / kCell; }
  double AlongZ(double z) const { return (z - low_z_) / kCell; }
  /// Row after row of rising z.
  const std::vector<std::uint32_t>& values() const { return values_; }
  /// Whether all cells within 4 m of a cell are there.
  bool IsInside(double along_x, double along_z) const;

 private:
  /// Of corner `a` and the edges from it.
  void MarkTriangle(const Eigen::Vector3f& a, const Eigen::Vector3f& u, const Eigen::Vector3f& v,
                    double floor);
  void Mark(const Eigen::Vector3f& point, double floor);

  double low_x_ = 0.0;
  double low_z_ = 0.0;
  int width_ = 0;
  int depth_ = 0;
  std::vector<std::uint32_t> values_;
};

}  // namespace bulletnav::bench
