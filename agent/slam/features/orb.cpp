// SPDX-License-Identifier: MIT
#include "agent/slam/features/orb.h"

#include <opencv2/features2d.hpp>

#include "agent/slam/features/grey.h"
#include "sim/base/error.h"

namespace bulletnav::agent {

void OrbSpec::Validate() const {
  if (features < 1 || levels < 1 || fast_threshold < 1) {
    throw sim::Error("expected features, levels and fast_threshold of at least 1");
  }
  if (!(scale > 1.0)) throw sim::Error("scale must be above 1");
}

OrbFeatures FindOrb(std::span<const std::uint8_t> rgb, int width_px, int height_px,
                    const OrbSpec& spec) {
  spec.Validate();
  const cv::Mat grey = GreyOf(rgb, width_px, height_px);
  constexpr int kPatch = 31;
  const auto orb =
      cv::ORB::create(spec.features, static_cast<float>(spec.scale), spec.levels, kPatch, 0, 2,
                      cv::ORB::HARRIS_SCORE, kPatch, spec.fast_threshold);
  std::vector<cv::KeyPoint> corners;
  cv::Mat rows;
  orb->detectAndCompute(grey, cv::noArray(), corners, rows);
  return FeaturesOf(corners, rows);
}

}  // namespace bulletnav::agent
