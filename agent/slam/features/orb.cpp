// SPDX-License-Identifier: MIT
#include "agent/slam/features/orb.h"

#include <cstddef>

#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>

#include "agent/slam/features/grey.h"
#include "sim/base/error.h"

namespace bulletnav::agent {

void OrbSpec::Validate() const {
  if (features < 1 || levels < 1 || fast_threshold < 1) {
    throw sim::Error("expected features, levels and fast_threshold of at least 1");
  }
  if (!(scale > 1.0)) throw sim::Error("scale must be above 1");
}

namespace {

constexpr int kPatch = 31;    // pixels around a corner that are described, and of edges without any
constexpr int kEnlarged = 2;  // of panoramas

OrbFeatures FindIn(const cv::Mat& grey, const OrbSpec& spec) {
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
