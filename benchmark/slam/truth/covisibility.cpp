// SPDX-License-Identifier: MIT
#include "benchmark/slam/truth/covisibility.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

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

void FindPoints(DepthThumbnail* thumbnail) {
  const DepthPicture& depth = thumbnail->depth;
  const Intrinsics& k = thumbnail->intrinsics;
  const std::size_t most = depth.metres.size() / (std::size_t{kPointEvery} * kPointEvery) + 1;
  thumbnail->points.reserve(most);
  thumbnail->facing.reserve(most);
  for (int row = kPointEvery / 2; row < depth.height; row += kPointEvery) {
    for (int col = kPointEvery / 2; col < depth.width; col += kPointEvery) {
      const float ahead = DepthAt(depth, col, row);
      if (!(ahead > 0.0f)) continue;
      const auto right = static_cast<float>((col - k.cx) / k.fx);
      const auto down = static_cast<float>((row - k.cy) / k.fy);
      thumbnail->points.emplace_back(ahead, -right * ahead, -down * ahead);
      thumbnail->facing.push_back(Facing(depth, k, col, row));
    }
  }
}

}  // namespace

DepthThumbnail Coarsened(const DepthPicture& depth, const Intrinsics& intrinsics) {
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
  return ThumbnailOf(std::move(coarse),
                     {intrinsics.fx / kCoarse, intrinsics.fy / kCoarse,
                      (intrinsics.cx - offset_x) / kCoarse, (intrinsics.cy - offset_y) / kCoarse});
}

DepthThumbnail ThumbnailOf(DepthPicture coarse, const Intrinsics& intrinsics) {
  DepthThumbnail thumbnail{std::move(coarse), intrinsics, {}, {}};
  FindPoints(&thumbnail);
  return thumbnail;
}

double ShareSeen(const DepthThumbnail& a, const DepthThumbnail& b, const sim::PlanarPose& X_AB) {
  if (a.points.empty()) return 0.0;
  const auto cosine = static_cast<float>(std::cos(X_AB.yaw));
  const auto sine = static_cast<float>(std::sin(X_AB.yaw));
  const auto x = static_cast<float>(X_AB.x);
  const auto y = static_cast<float>(X_AB.y);
  const auto fx = static_cast<float>(b.intrinsics.fx);
  const auto fy = static_cast<float>(b.intrinsics.fy);
  const auto cx = static_cast<float>(b.intrinsics.cx);
  const auto cy = static_cast<float>(b.intrinsics.cy);
  int seen = 0;
  for (std::size_t i = 0; i < a.points.size(); ++i) {
    const Eigen::Vector3f& point = a.points[i];
    const float dx = point.x() - x;
    const float dy = point.y() - y;
    if (a.facing[i].dot(Eigen::Vector3f(-dx, -dy, -point.z())) < -kBehind) continue;
    const float ahead = cosine * dx + sine * dy;
    const float left = cosine * dy - sine * dx;
    constexpr float kNear = 0.05f;
    if (ahead < kNear) continue;
    const float u = std::floor(cx - fx * left / ahead + 0.5f);
    const float v = std::floor(cy - fy * point.z() / ahead + 0.5f);
    const bool is_inside = u >= 0.0f && v >= 0.0f && u < static_cast<float>(b.depth.width) &&
                           v < static_cast<float>(b.depth.height);
    if (!is_inside) continue;
    const float depth = DepthAt(b.depth, static_cast<int>(u), static_cast<int>(v));
    if (depth > 0.0f && std::abs(depth - ahead) <= kOffShare * ahead + kOffMetres) ++seen;
  }
  return static_cast<double>(seen) / static_cast<double>(a.points.size());
}

double Covisibility(const DepthThumbnail& a, const DepthThumbnail& b, const sim::PlanarPose& X_AB) {
  return std::min(ShareSeen(a, b, X_AB), ShareSeen(b, a, sim::Inverse(X_AB)));
}

}  // namespace bulletnav::bench
