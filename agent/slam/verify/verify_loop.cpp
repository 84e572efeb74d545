// SPDX-License-Identifier: MIT
// With features/ all that knows OpenCV.
#include "agent/slam/verify/verify_loop.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <opencv2/calib3d.hpp>
#include <opencv2/core.hpp>

#include "sim/base/check.h"
#include "sim/base/error.h"

namespace bulletnav::agent {
namespace {

constexpr int kPoseCorners = 4;  // P3P takes three and a fourth to choose among its answers

/// The nearest of some descriptors, and how near it and the next are.
struct Nearest {
  int place = -1;
  int bits = kDescriptorBits + 1;
  int second_bits = kDescriptorBits + 1;

  void Take(int candidate, int candidate_bits) {
    if (candidate_bits < bits) {
      second_bits = bits;
      place = candidate;
      bits = candidate_bits;
    } else {
      second_bits = std::min(second_bits, candidate_bits);
    }
  }
  bool IsClear(const VerifySpec& spec) const {
    return place >= 0 && bits <= spec.match_bits && bits < spec.ratio * second_bits;
  }
};

/// Points in front of camera A and where B sees them.
struct Points {
  std::vector<cv::Point3d> in_a;
  std::vector<cv::Point2d> in_b;
};

Points PointsOf(const DepthCorners& a, const DepthCorners& b, const Pinhole& camera,
                const std::vector<std::pair<int, int>>& matches) {
  Points points;
  points.in_a.reserve(matches.size());
  points.in_b.reserve(matches.size());
  for (const auto& [i, j] : matches) {
    const double depth = a.depths_m[static_cast<std::size_t>(i)];
    if (!(depth > 0.0)) continue;
    const Corner& from = a.features->corners[static_cast<std::size_t>(i)];
    const Corner& to = b.features->corners[static_cast<std::size_t>(j)];
    points.in_a.emplace_back((from.x - camera.cx) / camera.fx * depth,
                             (from.y - camera.cy) / camera.fy * depth, depth);
    points.in_b.emplace_back(to.x, to.y);
  }
  return points;
}

SpatialPose PoseOf(const cv::Mat& rotation_vector, const cv::Mat& translation) {
  const auto at = [](const cv::Mat& vector) {
    return Eigen::Vector3d(vector.at<double>(0), vector.at<double>(1), vector.at<double>(2));
  };
  return {at(translation), RotationBy(at(rotation_vector))};
}

}  // namespace

void VerifySpec::Validate() const {
  if (!(ratio > 0.0 && ratio <= 1.0)) throw sim::Error("ratio must be above 0 and at most 1");
  if (match_bits < 0 || inliers < kPoseCorners || iterations < 1) {
    throw sim::Error(
        "expected match_bits of at least 0, inliers of at least 4, iterations of at "
        "least 1");
  }
  if (!(pixels > 0.0 && tilt_deg > 0.0 && rise_m > 0.0 && distance_m > 0.0)) {
    throw sim::Error("pixels, tilt_deg, rise_m and distance_m must be positive");
  }
}

std::vector<float> DepthsAt(std::span<const float> depth, int width_px, int height_px,
                            const OrbFeatures& features) {
  const auto width = static_cast<std::size_t>(width_px);
  BULLETNAV_CHECK(depth.size() == width * static_cast<std::size_t>(height_px));
  std::vector<float> depths;
  depths.reserve(features.corners.size());
  for (const Corner& corner : features.corners) {
    const int col = std::clamp(static_cast<int>(std::lround(corner.x)), 0, width_px - 1);
    const int row = std::clamp(static_cast<int>(std::lround(corner.y)), 0, height_px - 1);
    depths.push_back(depth[static_cast<std::size_t>(row) * width + static_cast<std::size_t>(col)]);
  }
  return depths;
}

std::vector<std::pair<int, int>> MutualMatches(const OrbFeatures& a, const OrbFeatures& b,
                                               const VerifySpec& spec) {
  std::vector<Nearest> of_a(a.descriptors.size());
  std::vector<Nearest> of_b(b.descriptors.size());
  std::vector<int> bits(b.descriptors.size());
  for (std::size_t i = 0; i < a.descriptors.size(); ++i) {
    CountDistances(a.descriptors[i], b.descriptors, bits);
    for (std::size_t j = 0; j < bits.size(); ++j) {
      of_a[i].Take(static_cast<int>(j), bits[j]);
      of_b[j].Take(static_cast<int>(i), bits[j]);
    }
  }
  std::vector<std::pair<int, int>> matches;
  matches.reserve(of_a.size());
  for (std::size_t i = 0; i < of_a.size(); ++i) {
    if (!of_a[i].IsClear(spec)) continue;
    const Nearest& back = of_b[static_cast<std::size_t>(of_a[i].place)];
    if (back.place == static_cast<int>(i)) {
      matches.emplace_back(static_cast<int>(i), of_a[i].place);
    }
  }
  return matches;
}

std::optional<CameraMotion> FindMotion(const DepthCorners& a, const DepthCorners& b,
                                       const Pinhole& camera, const VerifySpec& spec) {
  BULLETNAV_CHECK(a.depths_m.size() == a.features->corners.size());
  const auto matches = MutualMatches(*a.features, *b.features, spec);
  const Points points = PointsOf(a, b, camera, matches);
  if (points.in_a.size() < static_cast<std::size_t>(spec.inliers)) return std::nullopt;
  const cv::Mat lens = (cv::Mat_<double>(3, 3) << camera.fx, 0.0, camera.cx, 0.0, camera.fy,
                        camera.cy, 0.0, 0.0, 1.0);
  cv::Mat rotation;
  cv::Mat translation;
  std::vector<int> inliers;
  constexpr double kConfidence = 0.999;
  const bool is_found = cv::solvePnPRansac(
      points.in_a, points.in_b, lens, cv::noArray(), rotation, translation, false, spec.iterations,
      static_cast<float>(spec.pixels), kConfidence, inliers, cv::SOLVEPNP_AP3P);
  if (!is_found || inliers.size() < static_cast<std::size_t>(spec.inliers)) return std::nullopt;
  Points good;
  good.in_a.reserve(inliers.size());
  good.in_b.reserve(inliers.size());
  for (const int inlier : inliers) {
    good.in_a.push_back(points.in_a[static_cast<std::size_t>(inlier)]);
    good.in_b.push_back(points.in_b[static_cast<std::size_t>(inlier)]);
  }
  cv::solvePnPRefineLM(good.in_a, good.in_b, lens, cv::noArray(), rotation, translation);
  const SpatialPose a_in_b = PoseOf(rotation, translation);
  if (!a_in_b.position.allFinite() || !a_in_b.rotation.coeffs().allFinite()) return std::nullopt;
  return CameraMotion{Inverse(a_in_b), static_cast<int>(matches.size()),
                      static_cast<int>(inliers.size())};
}

std::optional<sim::PlanarPose> LevelMotion(const SpatialPose& X_AB, const VerifySpec& spec) {
  const Eigen::Vector3d ahead = X_AB.rotation * Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d down = X_AB.rotation * Eigen::Vector3d::UnitY();
  const bool is_level = down.y() >= std::cos(sim::DegToRad(spec.tilt_deg));
  const bool is_near = X_AB.position.norm() <= spec.distance_m;
  if (!is_level || !is_near || std::abs(X_AB.position.y()) > spec.rise_m) return std::nullopt;
  return sim::PlanarPose{X_AB.position.z(), -X_AB.position.x(), std::atan2(-ahead.x(), ahead.z())};
}

}  // namespace bulletnav::agent
