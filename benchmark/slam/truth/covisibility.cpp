// SPDX-License-Identifier: MIT
#include "benchmark/slam/truth/covisibility.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include <Eigen/Geometry>

#include "sim/base/check.h"

namespace bulletnav::bench {
namespace {

constexpr int kCoarse = 4;      // pixels of the picture a pixel of the coarse one
constexpr int kPointEvery = 4;  // coarse pixels a point, along each side
constexpr float kOffShare = 0.05f;
constexpr float kOffMetres = 0.05f;
/// How far behind a surface a camera may seem to be that sees its front: bodies keep farther from
/// walls, and planes through few pixels are not exact.
constexpr float kBehind = 0.1f;
constexpr float kNearest = 0.05f;  // metres; points before a camera are seen from there on

float DepthAt(const DepthPicture& depth, int col, int row) {
  return depth.metres[static_cast<std::size_t>(row) * static_cast<std::size_t>(depth.width) +
                      static_cast<std::size_t>(col)];
}

/// Of one over depth at a pixel, along a row or a column: by the neighbour whose depth is more like
/// the pixel's, so as not to reach over an edge. Nothing without neighbours. On a plane one over
/// depth rises evenly over the picture.
std::optional<float> Slope(const DepthPicture& depth, int col, int row, bool is_along_row) {
  const float here = 1.0f / DepthAt(depth, col, row);
  std::optional<float> slope;
  for (const int side : {-1, 1}) {
    const int c = is_along_row ? col + side : col;
    const int r = is_along_row ? row : row + side;
    if (c < 0 || r < 0 || c >= depth.width || r >= depth.height) continue;
    const float there = DepthAt(depth, c, r);
    if (!(there > 0.0f)) continue;
    const float found = (1.0f / there - here) * static_cast<float>(side);
    if (!slope || std::abs(found) < std::abs(*slope)) slope = found;
  }
  return slope;
}

/// The direction, seen from the body, that the surface at a pixel faces; zero if it is not known.
Eigen::Vector3f Facing(const DepthPicture& depth, const Intrinsics& k, int col, int row) {
  const std::optional<float> along = Slope(depth, col, row, true);
  const std::optional<float> down = Slope(depth, col, row, false);
  if (!along || !down) return Eigen::Vector3f::Zero();
  const float by_u = *along * static_cast<float>(k.fx);
  const float by_v = *down * static_cast<float>(k.fy);
  const auto u = static_cast<float>((col - k.cx) / k.fx);
  const auto v = static_cast<float>((row - k.cy) / k.fy);
  // A plane n . p = 1 has n_u u + n_v v + n_ahead = 1 / depth.
  const float by_ahead = 1.0f / DepthAt(depth, col, row) - u * by_u - v * by_v;
  return Eigen::Vector3f(-by_ahead, by_u, by_v).normalized();
}

Eigen::Vector3f PointAt(const DepthPicture& depth, const Intrinsics& k, int col, int row) {
  const float ahead = DepthAt(depth, col, row);
  const auto right = static_cast<float>((col - k.cx) / k.fx);
  const auto down = static_cast<float>((row - k.cy) / k.fy);
  return {ahead, -right * ahead, -down * ahead};
}

Eigen::Vector3f PointAt(const DepthPicture& depth, const agent::PanoramaLens& lens, int col,
                        int row) {
  return lens.PointAt({double(col), double(row), DepthAt(depth, col, row)}).cast<float>();
}

/// From a pixel's point to that of the neighbour whose depth is more like it, along a row or a
/// column, as if it were the next one. Nothing without neighbours.
std::optional<Eigen::Vector3f> StepOnSurface(const DepthPicture& depth,
                                             const agent::PanoramaLens& lens, int col, int row,
                                             bool is_along_row) {
  const Eigen::Vector3f here = PointAt(depth, lens, col, row);
  std::optional<Eigen::Vector3f> step;
  float off = 0.0f;
  for (const int side : {-1, 1}) {
    // A panorama's ends meet.
    const int c = is_along_row ? (col + side + depth.width) % depth.width : col;
    const int r = is_along_row ? row : row + side;
    if (r < 0 || r >= depth.height) continue;
    const float there = DepthAt(depth, c, r);
    if (!(there > 0.0f)) continue;
    const float apart = std::abs(there - DepthAt(depth, col, row));
    if (step && apart >= off) continue;
    step = (PointAt(depth, lens, c, r) - here) * static_cast<float>(side);
    off = apart;
  }
  return step;
}

Eigen::Vector3f Facing(const DepthPicture& depth, const agent::PanoramaLens& lens, int col,
                       int row) {
  const auto along = StepOnSurface(depth, lens, col, row, true);
  const auto down = StepOnSurface(depth, lens, col, row, false);
  if (!along || !down) return Eigen::Vector3f::Zero();
  const Eigen::Vector3f normal = along->cross(*down).normalized();
  // Towards the camera.
  return normal.dot(PointAt(depth, lens, col, row)) > 0.0f ? Eigen::Vector3f(-normal) : normal;
}

template <class Lens>
void FindPoints(const Lens& lens, DepthThumbnail* thumbnail) {
  const DepthPicture& depth = thumbnail->depth;
  const std::size_t most = depth.metres.size() / (std::size_t{kPointEvery} * kPointEvery) + 1;
  thumbnail->points.reserve(most);
  thumbnail->facing.reserve(most);
  for (int row = kPointEvery / 2; row < depth.height; row += kPointEvery) {
    for (int col = kPointEvery / 2; col < depth.width; col += kPointEvery) {
      if (!(DepthAt(depth, col, row) > 0.0f)) continue;
      thumbnail->points.push_back(PointAt(depth, lens, col, row));
      thumbnail->facing.push_back(Facing(depth, lens, col, row));
    }
  }
}

/// A pixel, and how deep in its picture a point is.
struct Place {
  float col = 0.0f;
  float row = 0.0f;
  float depth = 0.0f;
};

/// Places of points in pictures of a pinhole; numbers of it as floats.
class PinholePlaces {
 public:
  explicit PinholePlaces(const Intrinsics& k)
      : fx_(static_cast<float>(k.fx)),
        fy_(static_cast<float>(k.fy)),
        cx_(static_cast<float>(k.cx)),
        cy_(static_cast<float>(k.cy)) {}

  std::optional<Place> Of(float ahead, float left, float up) const {
    if (ahead < kNearest) return std::nullopt;
    return Place{std::floor(cx_ - fx_ * left / ahead + 0.5f),
                 std::floor(cy_ - fy_ * up / ahead + 0.5f), ahead};
  }

 private:
  float fx_, fy_, cx_, cy_;
};

class PanoramaPlaces {
 public:
  explicit PanoramaPlaces(const agent::PanoramaLens& lens) : lens_(lens) {}

  std::optional<Place> Of(float ahead, float left, float up) const {
    if (std::hypot(ahead, left) < kNearest) return std::nullopt;
    const agent::PicturePoint place =
        lens_.PlaceOf(Eigen::Vector3f(ahead, left, up).cast<double>());
    return Place{static_cast<float>(std::floor(place.col + 0.5)),
                 static_cast<float>(std::floor(place.row + 0.5)),
                 static_cast<float>(place.level_m)};
  }

 private:
  agent::PanoramaLens lens_;
};

PinholePlaces PlacesOf(const Intrinsics& k) {
  return PinholePlaces(k);
}
PanoramaPlaces PlacesOf(const agent::PanoramaLens& lens) {
  return PanoramaPlaces(lens);
}

/// From a level camera to another one as high.
class LevelStep {
 public:
  explicit LevelStep(const sim::PlanarPose& X_AB)
      : cosine_(static_cast<float>(std::cos(X_AB.yaw))),
        sine_(static_cast<float>(std::sin(X_AB.yaw))),
        x_(static_cast<float>(X_AB.x)),
        y_(static_cast<float>(X_AB.y)) {}

  /// From camera b to a point, both seen from a.
  Eigen::Vector3f FromB(const Eigen::Vector3f& point) const {
    return {point.x() - x_, point.y() - y_, point.z()};
  }
  /// The same, seen from b.
  Eigen::Vector3f InB(const Eigen::Vector3f& d) const {
    return {cosine_ * d.x() + sine_ * d.y(), cosine_ * d.y() - sine_ * d.x(), d.z()};
  }

 private:
  float cosine_, sine_, x_, y_;
};

/// The same between cameras as they are.
class TiltedStep {
 public:
  TiltedStep(const CameraTilt& a, const CameraTilt& b, const sim::PlanarPose& X_AB) {
    const Eigen::Vector3d level_move(X_AB.x, X_AB.y, b.height - a.height);
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(X_AB.yaw, Eigen::Vector3d::UnitZ()).toRotationMatrix() *
        b.level_from_camera;
    b_in_a_ = (a.level_from_camera.transpose() * level_move).cast<float>();
    b_from_a_ = (turn.transpose() * a.level_from_camera).cast<float>();
  }

  Eigen::Vector3f FromB(const Eigen::Vector3f& point) const { return point - b_in_a_; }
  Eigen::Vector3f InB(const Eigen::Vector3f& d) const { return b_from_a_ * d; }

 private:
  Eigen::Vector3f b_in_a_;
  Eigen::Matrix3f b_from_a_;
};

template <class Places, class Step>
double ShareSeenAt(const DepthThumbnail& a, const DepthThumbnail& b, const Places& places,
                   const Step& step) {
  int seen = 0;
  for (std::size_t i = 0; i < a.points.size(); ++i) {
    const Eigen::Vector3f from_b = step.FromB(a.points[i]);
    if (a.facing[i].dot(Eigen::Vector3f(-from_b)) < -kBehind) continue;
    const Eigen::Vector3f in_b = step.InB(from_b);
    const std::optional<Place> place = places.Of(in_b.x(), in_b.y(), in_b.z());
    if (!place) continue;
    const bool is_inside = place->col >= 0.0f && place->row >= 0.0f &&
                           place->col < static_cast<float>(b.depth.width) &&
                           place->row < static_cast<float>(b.depth.height);
    if (!is_inside) continue;
    const float depth =
        DepthAt(b.depth, static_cast<int>(place->col), static_cast<int>(place->row));
    if (depth > 0.0f && std::abs(depth - place->depth) <= kOffShare * place->depth + kOffMetres) {
      ++seen;
    }
  }
  return static_cast<double>(seen) / static_cast<double>(a.points.size());
}

CameraLens Every(const Intrinsics& k, int n, int offset_x, int offset_y) {
  return Intrinsics{k.fx / n, k.fy / n, (k.cx - offset_x) / n, (k.cy - offset_y) / n};
}
CameraLens Every(const agent::PanoramaLens& lens, int n, int offset_x, int offset_y) {
  return lens.Every(n, offset_x, offset_y);
}

}  // namespace

DepthThumbnail Coarsened(const DepthPicture& depth, const CameraLens& lens) {
  BULLETNAV_CHECK(depth.width > 0 && depth.height > 0 &&
                  depth.metres.size() == static_cast<std::size_t>(depth.width) *
                                             static_cast<std::size_t>(depth.height));
  DepthPicture coarse;
  coarse.width = std::max(1, depth.width / kCoarse);
  coarse.height = std::max(1, depth.height / kCoarse);
  const int offset_x = std::min(kCoarse / 2, depth.width - 1);
  const int offset_y = std::min(kCoarse / 2, depth.height - 1);
  coarse.metres.reserve(static_cast<std::size_t>(coarse.width) *
                        static_cast<std::size_t>(coarse.height));
  for (int row = 0; row < coarse.height; ++row) {
    for (int col = 0; col < coarse.width; ++col) {
      coarse.metres.push_back(DepthAt(depth, col * kCoarse + offset_x, row * kCoarse + offset_y));
    }
  }
  return ThumbnailOf(std::move(coarse), std::visit(
                                            [&](const auto& of) {
                                              return Every(of, kCoarse, offset_x, offset_y);
                                            },
                                            lens));
}

DepthThumbnail ThumbnailOf(DepthPicture coarse, const CameraLens& lens) {
  DepthThumbnail thumbnail{std::move(coarse), lens, {}, {}, {}};
  std::visit(
      [&thumbnail](const auto& of) {
        FindPoints(of, &thumbnail);
      },
      lens);
  return thumbnail;
}

double ShareSeen(const DepthThumbnail& a, const DepthThumbnail& b, const sim::PlanarPose& X_AB) {
  if (a.points.empty()) return 0.0;
  return std::visit(
      [&](const auto& lens) {
        if (!a.tilt && !b.tilt) return ShareSeenAt(a, b, PlacesOf(lens), LevelStep(X_AB));
        const TiltedStep step(a.tilt.value_or(CameraTilt{}), b.tilt.value_or(CameraTilt{}), X_AB);
        return ShareSeenAt(a, b, PlacesOf(lens), step);
      },
      b.lens);
}

double Covisibility(const DepthThumbnail& a, const DepthThumbnail& b, const sim::PlanarPose& X_AB) {
  return std::min(ShareSeen(a, b, X_AB), ShareSeen(b, a, sim::Inverse(X_AB)));
}

}  // namespace bulletnav::bench
