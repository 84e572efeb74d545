// SPDX-License-Identifier: MIT
#include "agent/slam/features/orb.h"

#include <algorithm>
#include <cstddef>

#include <fmt/core.h>
#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>

#include "agent/slam/features/grey.h"
#include "sim/base/error.h"

namespace bulletnav::agent {

void OrbSpec::Validate() const {
  if (features < 1 || levels < 1 || fast_threshold < 1) {
    throw sim::Error("expected features, levels and fast_threshold of at least 1");
  }
  constexpr int kMostFeatures = 100'000;
  constexpr int kMostLevels = 32;
  constexpr double kMostScale = 10.0;
  if (features > kMostFeatures) {
    throw sim::Error("expected features of at most 100000");
  }
  if (levels > kMostLevels) throw sim::Error("expected levels of at most 32");
  if (!(scale > 1.0)) throw sim::Error("scale must be above 1");
  if (!(scale <= kMostScale)) throw sim::Error("expected a scale of at most 10");
}

namespace {

constexpr int kPatch = 31;    // pixels around a corner that are described, and of edges without any
constexpr int kEnlarged = 2;  // of panoramas

/// Throws if a level of the pyramid has no pixel.
void CheckLevels(const cv::Mat& grey, const OrbSpec& spec) {
  double side = std::min(grey.cols, grey.rows);
  for (int level = 1; level < spec.levels; ++level) side /= spec.scale;
  if (side >= 0.5) return;
  throw sim::Error(fmt::format(
      "corners: {} levels, each {} times smaller, are too many for pictures of {} x {} pixels; "
      "lower 'levels' or 'scale' of 'orb', or take larger pictures",
      spec.levels, spec.scale, grey.cols, grey.rows));
}

OrbFeatures FindIn(const cv::Mat& grey, const OrbSpec& spec) {
  CheckLevels(grey, spec);
  const auto orb =
      cv::ORB::create(spec.features, static_cast<float>(spec.scale), spec.levels, kPatch, 0, 2,
                      cv::ORB::HARRIS_SCORE, kPatch, spec.fast_threshold);
  std::vector<cv::KeyPoint> corners;
  cv::Mat rows;
  orb->detectAndCompute(grey, cv::noArray(), corners, rows);
  return FeaturesOf(corners, rows);
}

}  // namespace

OrbFeatures FindOrb(std::span<const std::uint8_t> rgb, int width_px, int height_px,
                    const OrbSpec& spec) {
  spec.Validate();
  return FindIn(GreyOf(rgb, width_px, height_px), spec);
}

OrbFeatures FindOrbAround(std::span<const std::uint8_t> rgb, int width_px, int height_px,
                          const OrbSpec& spec) {
  spec.Validate();
  constexpr int kRim = 2 * kPatch;
  cv::Mat large;
  cv::resize(GreyOf(rgb, width_px, height_px), large, {}, kEnlarged, kEnlarged, cv::INTER_LINEAR);
  cv::Mat around;
  cv::copyMakeBorder(large, around, 0, 0, kRim, kRim, cv::BORDER_WRAP);
  const OrbFeatures all = FindIn(around, spec);
  OrbFeatures found;
  for (std::size_t i = 0; i < all.corners.size(); ++i) {
    Corner corner = all.corners[i];
    corner.x = (corner.x - kRim + 0.5f) / kEnlarged - 0.5f;
    corner.y = (corner.y + 0.5f) / kEnlarged - 0.5f;
    corner.size_px /= kEnlarged;
    // Of the rims, each column is in the picture once.
    if (corner.x < -0.5f || corner.x >= static_cast<float>(width_px) - 0.5f) continue;
    found.corners.push_back(corner);
    found.descriptors.push_back(all.descriptors[i]);
  }
  return found;
}

}  // namespace bulletnav::agent
