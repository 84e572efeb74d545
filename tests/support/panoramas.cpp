// SPDX-License-Identifier: MIT
#include "tests/support/panoramas.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <Eigen/Geometry>

#include "sim/math/pose.h"
#include "sim/render/projection.h"

namespace bulletnav::tests {
namespace {

/// Whether depth changes by more than a tenth between a pixel and one beside it.
bool IsEdge(const Panorama& p, int row, int col) {
  const float here = p.depth_at(row, col);
  for (int r = std::max(0, row - 1); r <= std::min(p.rows - 1, row + 1); ++r) {
    for (int dc = -1; dc <= 1; ++dc) {
      const float there = p.depth_at(r, (col + dc + p.cols) % p.cols);
      if (std::abs(there - here) > 0.1f * std::min(there, here)) return true;
    }
  }
  return false;
}

Eigen::Vector3f Ray(const sim::PanoramaSpec& spec, int row, int col, double yaw) {
  const double turns = (col + 0.5) / spec.cols;
  double clockwise = 2.0 * sim::kPi * turns - sim::kPi;
  double up = 1.0 - 2.0 * (row + 0.5) / spec.rows;
  if (spec.projection == sim::Projection::kEquirectangular) up = std::tan(0.5 * sim::kPi * up);
  if (spec.projection == sim::Projection::kCubeStrip) {
    const double side = std::floor(4.0 * turns);
    const double across = 2.0 * (4.0 * turns - side) - 1.0;
    clockwise = (side - 1.5) * 0.5 * sim::kPi + std::atan(across);
    up /= std::hypot(1.0, across);
  }
  const double heading = yaw - clockwise;
  return Eigen::Vector3f(static_cast<float>(-std::sin(heading)), static_cast<float>(up),
                         static_cast<float>(-std::cos(heading)))
      .normalized();
}

/// From the corners of the field of view: ahead, to the right, up.
Eigen::Vector3f Ray(const sim::PinholeSpec& spec, int row, int col, double yaw) {
  const double pitch = sim::DegToRad(spec.pitch_deg);
  const Eigen::Vector3d level(-std::sin(yaw), 0.0, -std::cos(yaw));
  const Eigen::Vector3d right(std::cos(yaw), 0.0, -std::sin(yaw));
  const Eigen::Vector3d ahead =
      std::cos(pitch) * level + std::sin(pitch) * Eigen::Vector3d::UnitY();
  const double reach = std::tan(0.5 * sim::DegToRad(spec.hfov_deg)) / (0.5 * spec.cols);
  const double across = reach * (col + 0.5 - 0.5 * spec.cols);
  const double up = reach * (0.5 * spec.rows - row - 0.5);
  return (ahead + across * right + up * right.cross(ahead)).normalized().cast<float>();
}

}  // namespace

Eigen::Vector3f RayDirection(const sim::CameraSpec& spec, int row, int col, float yaw) {
  return std::visit(
      [&](const auto& s) {
        return Ray(s, row, col, yaw);
      },
      spec);
}

Panorama RenderPanorama(const sim::RenderScene& scene, const sim::CameraSpec& spec,
                        const sim::CameraPose& camera) {
  const sim::PictureSize size = sim::SizeOf(spec);
  Panorama p{size.rows, size.cols, std::vector<std::uint8_t>(3 * size.pixels()),
             std::vector<float>(size.pixels())};
  scene.MakeRenderer(spec)->Render({&camera, 1}, p.color, p.depth);
  return p;
}

void Agreement::Add(const Panorama& a, const Panorama& b) {
  for (int r = 0; r < a.rows; ++r) {
    for (int c = 0; c < a.cols; ++c) {
      const sim::Rgb8 x = a.color_at(r, c);
      const sim::Rgb8 y = b.color_at(r, c);
      int worst = 0;
      for (std::size_t k = 0; k < 3; ++k) worst = std::max(worst, std::abs(x[k] - y[k]));
      good_color_ += worst <= 8 ? 1 : 0;
      ++color_pixels_;
      if (IsEdge(a, r, c)) continue;
      const float depth = a.depth_at(r, c);
      const float error = std::abs(depth - b.depth_at(r, c));
      good_depth_ += error <= std::max(0.01f, 0.01f * depth) ? 1 : 0;
      ++depth_pixels_;
    }
  }
}

}  // namespace bulletnav::tests
