// SPDX-License-Identifier: MIT
#include "sim/render/egl/views.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "sim/base/elementary.h"
#include "sim/math/pose.h"
#include "sim/math/rotation.h"

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
  view.forward = Vec(static_cast<float>(Sin(a)), 0.0f, static_cast<float>(-Cos(a)));
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
  view.up = Vec(0.0f, static_cast<float>(Cos(pitch)), static_cast<float>(Sin(pitch)));
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
  const double tan_x = Tan(half_angle);
  const double tan_y = sees_poles ? 1.0 : 1.0 / Cos(half_angle);
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

namespace {

/// Of the upper left of the four pixels around a ray of `view`, and which of them is nearest.
std::int32_t PlaceOfRay(const ViewLayout& layout, const FlatView& view, const Vec& ray) {
  const float ahead = view.forward.dot(ray);
  const auto pixel = [&](float across, float tangent, int size) {
    return (0.5f + 0.5f * across / (tangent * ahead)) * static_cast<float>(size) - 0.5f;
  };
  const float x = pixel(view.right.dot(ray), view.tan_x, view.width);
  const float y = pixel(view.up.dot(ray), view.tan_y, view.height);
  const int low_x = std::clamp(static_cast<int>(std::floor(x)), 1, view.width - 3);
  const int low_y = std::clamp(static_cast<int>(std::floor(y)), 1, view.height - 3);
  const int nearest = (x - static_cast<float>(low_x) > 0.5f ? 1 : 0) +
                      (y - static_cast<float>(low_y) > 0.5f ? 2 : 0);
  return 4 * (low_y * layout.width + view.first_x + low_x) + nearest;
}

}  // namespace

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
      places[r * width + column] = PlaceOfRay(layout, layout.views[v], d);
    }
  }
  return places;
}

ViewAxes::ViewAxes(const FlatView& view, const CameraPose& camera) {
  const Eigen::Matrix3f turn = RotationAbout<float>(Vec::UnitY(), camera.yaw);
  right = turn * view.right / view.tan_x;
  up = turn * view.up / view.tan_y;
  forward = turn * view.forward;
}

}  // namespace bulletnav::sim
