// SPDX-License-Identifier: MIT
#include "sim/render/egl/views.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "sim/math/pose.h"

namespace bulletnav::sim {
namespace {

using Vec = Eigen::Vector3f;

constexpr double kBorder = 2.0;  // pixels beyond a view's edge, for the last ray's neighbours

int PixelsFor(double extent, double pixel) {
  return static_cast<int>(std::ceil(extent / pixel + 2.0 * kBorder));
}

std::size_t MostAhead(const ViewLayout& layout, const Vec& d) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < layout.views.size(); ++i) {
    if (layout.views[i].forward.dot(d) > layout.views[best].forward.dot(d)) best = i;
  }
  return best;
}

FlatView Upright(double clockwise_from_behind) {
  const double a = clockwise_from_behind - kPi;
  FlatView view;
  view.forward = Vec(static_cast<float>(std::sin(a)), 0.0f, static_cast<float>(-std::cos(a)));
  view.up = Vec::UnitY();
  view.right = view.forward.cross(view.up);
  return view;
}

}  // namespace

ViewLayout::ViewLayout(const CameraSpec& spec, double oversampling) {
  std::visit(
      [&](const auto& s) {
        Cover(s, oversampling);
      },
      spec);
}

void ViewLayout::Cover(const PinholeSpec& spec, double oversampling) {
  const double pitch = DegToRad(spec.pitch_deg);
  FlatView view;
  view.right = Vec::UnitX();
  view.up = Vec(0.0f, static_cast<float>(std::cos(pitch)), static_cast<float>(std::sin(pitch)));
  view.forward = view.up.cross(view.right);
  views.push_back(view);
  ring = 1;
  const double pixel = 2.0 * spec.tan_x() / spec.cols / oversampling;
  SetSizes({spec.tan_x(), spec.tan_y()}, {pixel, pixel});
}

void ViewLayout::Cover(const PanoramaSpec& spec, double oversampling) {
  const bool sees_poles = spec.projection == Projection::kEquirectangular;
  ring = spec.projection == Projection::kCylindrical ? 6 : 4;
  const double half_angle = kPi / ring;
  const double column = 2.0 * kPi / spec.cols / oversampling;
  const double row = (sees_poles ? kPi : 2.0) / spec.rows / oversampling;
  const double tan_x = std::tan(half_angle);
  const double tan_y = sees_poles ? 1.0 : 1.0 / std::cos(half_angle);
  for (int k = 0; k < ring; ++k) views.push_back(Upright((2 * k + 1) * half_angle));
  if (sees_poles) {
    // Turned like the ring, so that the six make a cube.
    FlatView up = views.front();
    up.up = -up.forward;
    up.forward = Vec::UnitY();
    FlatView down = views.front();
    down.up = down.forward;
    down.forward = -Vec::UnitY();
    views.push_back(up);
    views.push_back(down);
  }
  SetSizes({tan_x, tan_y}, {column, row});
}

void ViewLayout::SetSizes(const Eigen::Array2d& tangents, const Eigen::Array2d& pixel) {
  for (FlatView& view : views) {
    view.width = PixelsFor(2.0 * tangents.x(), pixel.x());
    view.height = PixelsFor(2.0 * tangents.y(), pixel.y());
    view.tan_x = static_cast<float>(tangents.x() * view.width / (view.width - 2.0 * kBorder));
    view.tan_y = static_cast<float>(tangents.y() * view.height / (view.height - 2.0 * kBorder));
    view.first_x = width;
    width += view.width;
    height = std::max(height, view.height);
  }
}

std::vector<std::int32_t> PlacesOfRays(const ViewLayout& layout, const RayGrid& rays, int stride) {
  const std::size_t cols = rays.x.size();
  const auto width = static_cast<std::size_t>(stride);
  std::vector<std::int32_t> places(width * rays.y.size());
  for (std::size_t r = 0; r < rays.y.size(); ++r) {
    for (std::size_t column = 0; column < width; ++column) {
      const std::size_t c =
          std::min(column, cols - 1);  // the padding looks where the last one does
      const Vec d = rays.Direction(r, c);
      std::size_t v = c * static_cast<std::size_t>(layout.ring) / cols;
      if (static_cast<int>(layout.views.size()) > layout.ring) v = MostAhead(layout, d);
      const FlatView& view = layout.views[v];
      const float ahead = view.forward.dot(d);
      const auto pixel = [&](float across, float tangent, int size) {
        return (0.5f + 0.5f * across / (tangent * ahead)) * static_cast<float>(size) - 0.5f;
      };
      const float x = pixel(view.right.dot(d), view.tan_x, view.width);
      const float y = pixel(view.up.dot(d), view.tan_y, view.height);
      const int low_x = std::clamp(static_cast<int>(std::floor(x)), 1, view.width - 3);
      const int low_y = std::clamp(static_cast<int>(std::floor(y)), 1, view.height - 3);
      const int nearest = (x - static_cast<float>(low_x) > 0.5f ? 1 : 0) +
                          (y - static_cast<float>(low_y) > 0.5f ? 2 : 0);
      places[r * width + column] = 4 * (low_y * layout.width + view.first_x + low_x) + nearest;
    }
  }
  return places;
}

ViewAxes::ViewAxes(const FlatView& view, const CameraPose& camera) {
  const Eigen::AngleAxisf turn(camera.yaw, Vec::UnitY());
  right = turn * view.right / view.tan_x;
  up = turn * view.up / view.tan_y;
  forward = turn * view.forward;
}

}  // namespace bulletnav::sim
