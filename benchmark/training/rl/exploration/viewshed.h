// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "agent/mapping/map_spec.h"
#include "agent/mapping/view_window.h"
#include "benchmark/training/rl/exploration/height_columns.h"
#include "sim/math/pose.h"

namespace bulletnav::bench {

/// What has been seen of a scene's floor and of what stands on it, on the cells of its columns.
struct SeenGround {
  std::vector<std::uint8_t> cells;
  std::int64_t count = 0;
  std::vector<float> weights;  // of all cells; empty: each counts 1
  double weight = 0.0;         // of those seen
};

/// A panorama of depth that is not drawn: what DepthRing would make of it, from the columns of a
/// scene. Rays of the panorama's rows below the horizon run over the columns one cell after the
/// other, so that the camera sees over a table and under its top as it would. Drops are not told
/// from floor that was not met. Cost: some 0.1 ms.
class Viewshed final : public agent::ViewWindow {
 public:
  /// Of a cylindrical panorama of 128 x 512, in cells of HeightColumns::kCell (checked).
  Viewshed(const agent::MapSpec& spec, double camera_height);

  /// Where the body is, in truth. What it sees in the next Project is added to `seen`; all must
  /// outlive that.
  void Place(const HeightColumns* columns, const sim::BodyPose& pose, SeenGround* seen);

  /// Looks from there; the panorama does not matter.
  void Project(const agent::Panorama& panorama, double x, double y, double yaw) override;

 private:
  static constexpr int kColumns = 512;
  struct Ray {
    float x, z;  // in the world, of a cell's length
    float map_x, map_y;
  };
  /// Rays of a column by the height at which they are at some range: those above bit b's lower end.
  using Rows = std::array<std::uint64_t, HeightColumns::kBits + 2>;

  void Look(const Ray& ray, float map_x, float map_y);
  void Meet(std::uint32_t column, const Rows& above, std::size_t cell, std::uint64_t* alive,
            bool* is_open);
  void See(std::size_t ground);

  int obstacle_bit_;           // the lowest of an obstacle
  std::vector<Rows> above_;    // [steps]
  std::vector<float> range_;   // [steps] in cells
  std::vector<double> ahead_;  // [kColumns] of their directions in the body's frame
  std::vector<double> left_;
  const HeightColumns* columns_ = nullptr;
  sim::BodyPose pose_;
  SeenGround* ground_ = nullptr;
  float x_ = 0.0f;  // of the body in columns
  float z_ = 0.0f;
};

}  // namespace bulletnav::bench
