// SPDX-License-Identifier: MIT
#include "agent/slam/verify/verify_panorama.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "sim/base/check.h"
#include "sim/math/rng.h"

namespace bulletnav::agent {
namespace {

constexpr double kOffShare = 0.05;   // of the distance that depth may be off
constexpr double kOffMetres = 0.05;  // and beside that
constexpr double kLeastApart = 0.5;  // metres between two points that are to give a turn
constexpr int kRefinements = 3;

/// A corner that was found again: where it is from both places.
struct PointPair {
  Eigen::Vector3d in_a;
  Eigen::Vector3d in_b;
  double tolerance = 0.0;  // metres that they may be apart
};

double Level(const Eigen::Vector3d& point) {
  return std::hypot(point.x(), point.y());
}

/// A point of B, seen from A.
Eigen::Vector3d From(const sim::PlanarPose& X_AB, const Eigen::Vector3d& point) {
  const double c = sim::Cos(X_AB.yaw);
  const double s = sim::Sin(X_AB.yaw);
  return {X_AB.x + c * point.x() - s * point.y(), X_AB.y + s * point.x() + c * point.y(),
          point.z()};
}

/// The motion that lays points of B over those of A as well as may be.
sim::PlanarPose Fitted(const std::vector<PointPair>& pairs) {
  Eigen::Vector3d middle_a = Eigen::Vector3d::Zero();
  Eigen::Vector3d middle_b = Eigen::Vector3d::Zero();
  double sum = 0.0;
  const auto weight = [](const PointPair& pair) {
    return 1.0 / (pair.tolerance * pair.tolerance);
  };
  for (const PointPair& pair : pairs) {
    middle_a += weight(pair) * pair.in_a;
    middle_b += weight(pair) * pair.in_b;
    sum += weight(pair);
  }
  middle_a /= sum;
  middle_b /= sum;
  double along = 0.0;
  double across = 0.0;
  for (const PointPair& pair : pairs) {
    const Eigen::Vector3d a = pair.in_a - middle_a;
    const Eigen::Vector3d b = pair.in_b - middle_b;
    along += weight(pair) * (a.x() * b.x() + a.y() * b.y());
    across += weight(pair) * (a.y() * b.x() - a.x() * b.y());
  }
  sim::PlanarPose motion;
  motion.yaw = sim::Atan2(across, along);
  const Eigen::Vector3d turned = From(motion, middle_b);
  motion.x = middle_a.x() - turned.x();
  motion.y = middle_a.y() - turned.y();
  return motion;
}

/// The pairs that agree with a motion.
std::vector<PointPair> Agreeing(const std::vector<PointPair>& pairs, const sim::PlanarPose& X_AB) {
  const double c = sim::Cos(X_AB.yaw);
  const double s = sim::Sin(X_AB.yaw);
  std::vector<PointPair> agreeing;
  for (const PointPair& pair : pairs) {
    const Eigen::Vector3d& b = pair.in_b;
    const Eigen::Vector3d off = {X_AB.x + c * b.x() - s * b.y() - pair.in_a.x(),
                                 X_AB.y + s * b.x() + c * b.y() - pair.in_a.y(),
                                 b.z() - pair.in_a.z()};
    if (off.squaredNorm() <= pair.tolerance * pair.tolerance) agreeing.push_back(pair);
  }
  return agreeing;
}

/// Whether two pairs of points can give a motion: they are apart, alike from both places.
bool CanFit(const PointPair& one, const PointPair& other) {
  const double in_a = Level(one.in_a - other.in_a);
  const double in_b = Level(one.in_b - other.in_b);
  return in_a >= kLeastApart && std::abs(in_a - in_b) <= one.tolerance + other.tolerance;
}

/// What agrees with the best of the motions that two pairs give.
std::vector<PointPair> LargestSet(const std::vector<PointPair>& pairs, int iterations) {
  std::vector<PointPair> best;
  sim::Rng rng(0, "panorama_motion");
  const int count = static_cast<int>(pairs.size());
  for (int i = 0; i < iterations; ++i) {
    const PointPair& one = pairs[static_cast<std::size_t>(rng.Below(count))];
    const PointPair& other = pairs[static_cast<std::size_t>(rng.Below(count))];
    if (!CanFit(one, other)) continue;
    std::vector<PointPair> agreeing = Agreeing(pairs, Fitted({one, other}));
    if (agreeing.size() > best.size()) best = std::move(agreeing);
  }
  return best;
}

std::vector<PointPair> PairsOf(const PlacedCorners& a, const PlacedCorners& b,
                               const std::vector<std::pair<int, int>>& matches,
                               const PanoramaLens& lens, const VerifySpec& spec) {
  std::vector<PointPair> pairs;
  pairs.reserve(matches.size());
  for (const auto& [i, j] : matches) {
    const Eigen::Vector3d& in_a = a.points[static_cast<std::size_t>(i)];
    const Eigen::Vector3d& in_b = b.points[static_cast<std::size_t>(j)];
    if (in_a.isZero() || in_b.isZero()) continue;
    const double far = std::max(Level(in_a), Level(in_b));
    pairs.push_back(
        {in_a, in_b, kOffMetres + far * std::max(kOffShare, spec.pixels * lens.column)});
  }
  return pairs;
}

}  // namespace

std::vector<Eigen::Vector3d> PointsAt(std::span<const float> level_m, int width_px, int height_px,
                                      const PanoramaLens& lens, const OrbFeatures& features) {
  const std::vector<float> distances = DepthsAt(level_m, width_px, height_px, features);
  std::vector<Eigen::Vector3d> points;
  points.reserve(distances.size());
  for (std::size_t i = 0; i < distances.size(); ++i) {
    const Corner& corner = features.corners[i];
    points.push_back(lens.PointAt({double{corner.x}, double{corner.y}, double{distances[i]}}));
  }
  return points;
}

std::optional<PanoramaMotion> FindMotion(const PlacedCorners& a, const PlacedCorners& b,
                                         const PanoramaLens& lens, const VerifySpec& spec) {
  BULLETNAV_CHECK(a.points.size() == a.features->corners.size() &&
                  b.points.size() == b.features->corners.size());
  const auto matches = MutualMatches(*a.features, *b.features, spec);
  const std::vector<PointPair> pairs = PairsOf(a, b, matches, lens, spec);
  const auto least = static_cast<std::size_t>(spec.inliers);
  if (pairs.size() < least) return std::nullopt;
  std::vector<PointPair> agreeing = LargestSet(pairs, spec.iterations);
  sim::PlanarPose motion;
  for (int i = 0; i < kRefinements; ++i) {
    if (agreeing.size() < least) return std::nullopt;
    motion = Fitted(agreeing);
    agreeing = Agreeing(pairs, motion);
  }
  if (agreeing.size() < least || std::hypot(motion.x, motion.y) > spec.distance_m) {
    return std::nullopt;
  }
  return PanoramaMotion{motion, static_cast<int>(matches.size()),
                        static_cast<int>(agreeing.size())};
}

}  // namespace bulletnav::agent
