// SPDX-License-Identifier: MIT
#include "benchmark/slam/truth/covisibility.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "sim/base/check.h"

namespace bulletnav::bench {
namespace {

constexpr int kCoarse = 4;      // pixels of the picture a pixel of the coarse one
constexpr int kPointEvery = 4;  // coarse pixels a point, along each side
constexpr float kOffShare = 0.05f;
constexpr float kOffMetres = 0.05f;

float DepthAt(const DepthPicture& depth, int col, int row) {
  return depth.metres[static_cast<std::size_t>(row) * static_cast<std::size_t>(depth.width) +
                      static_cast<std::size_t>(col)];
}

std::vector<Eigen::Vector3f> PointsOf(const DepthPicture& depth, const Intrinsics& k) {
  std::vector<Eigen::Vector3f> points;
  points.reserve(depth.metres.size() / (std::size_t{kPointEvery} * kPointEvery) + 1);
  for (int row = kPointEvery / 2; row < depth.height; row += kPointEvery) {
    for (int col = kPointEvery / 2; col < depth.width; col += kPointEvery) {
      const float ahead = DepthAt(depth, col, row);
      if (!(ahead > 0.0f)) continue;
      const auto right = static_cast<float>((col - k.cx) / k.fx);
      const auto down = static_cast<float>((row - k.cy) / k.fy);
      points.emplace_back(ahead, -right * ahead, -down * ahead);
    }
  }
  return points;
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
  DepthThumbnail thumbnail{std::move(coarse), intrinsics, {}};
  thumbnail.points = PointsOf(thumbnail.depth, thumbnail.intrinsics);
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
  for (const Eigen::Vector3f& point : a.points) {
    const float dx = point.x() - x;
    const float dy = point.y() - y;
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
