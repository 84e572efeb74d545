// SPDX-License-Identifier: MIT
#include "agent/slam/features/gftt.h"

#include <opencv2/features2d.hpp>

#include "agent/slam/features/grey.h"
#include "sim/base/error.h"

namespace bulletnav::agent {

void GfttSpec::Validate() const {
  if (features < 1) throw sim::Error("expected features of at least 1");
  if (!(quality > 0.0 && quality < 1.0 && apart_px >= 0.0)) {
    throw sim::Error("quality must lie between 0 and 1, and apart_px must not be negative");
  }
}

OrbFeatures FindGftt(std::span<const std::uint8_t> rgb, int width_px, int height_px,
                     const GfttSpec& spec) {
  spec.Validate();
  const cv::Mat grey = GreyOf(rgb, width_px, height_px);
  const auto gftt = cv::GFTTDetector::create(spec.features, spec.quality, spec.apart_px);
  std::vector<cv::KeyPoint> corners;
  gftt->detect(grey, corners);
  cv::Mat rows;
  // One level of the pyramid: corners are found in the picture as it is.
  cv::ORB::create(spec.features, 1.2F, 1)->compute(grey, corners, rows);
  return FeaturesOf(corners, rows);
}

}  // namespace bulletnav::agent
