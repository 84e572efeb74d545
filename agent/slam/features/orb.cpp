// SPDX-License-Identifier: MIT
// All that knows OpenCV.
#include "agent/slam/features/orb.h"

#include <cstddef>
#include <cstring>
#include <string>

#include <opencv2/core.hpp>
#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>

#include "sim/base/error.h"

namespace bulletnav::agent {
namespace {

/// OpenCV's own threads would only get in the way of ours.
void StayInThisThread() {
  if (cv::getNumThreads() != 1) cv::setNumThreads(1);
}

cv::Mat GreyOf(std::span<const std::uint8_t> rgb, int width_px, int height_px) {
  const auto bytes = static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px) * 3;
  if (width_px < 1 || height_px < 1 || rgb.size() != bytes) {
    throw sim::Error("a picture of " + std::to_string(width_px) + " x " +
                     std::to_string(height_px) + " cannot have " + std::to_string(rgb.size()) +
                     " bytes of RGB; give three a pixel");
  }
  // OpenCV has no matrices that are only read; cvtColor does not write to its source.
  const cv::Mat color(height_px, width_px, CV_8UC3, const_cast<std::uint8_t*>(rgb.data()));
  cv::Mat grey;
  cv::cvtColor(color, grey, cv::COLOR_RGB2GRAY);
  return grey;
}

}  // namespace

void OrbSpec::Validate() const {
  if (features < 1 || levels < 1 || fast_threshold < 1) {
    throw sim::Error("expected features, levels and fast_threshold of at least 1");
  }
  if (!(scale > 1.0)) throw sim::Error("scale must be above 1");
}

OrbFeatures FindOrb(std::span<const std::uint8_t> rgb, int width_px, int height_px,
                    const OrbSpec& spec) {
  spec.Validate();
  StayInThisThread();
  const cv::Mat grey = GreyOf(rgb, width_px, height_px);
  constexpr int kPatch = 31;
  const auto orb =
      cv::ORB::create(spec.features, static_cast<float>(spec.scale), spec.levels, kPatch, 0, 2,
                      cv::ORB::HARRIS_SCORE, kPatch, spec.fast_threshold);
  std::vector<cv::KeyPoint> corners;
  cv::Mat rows;
  orb->detectAndCompute(grey, cv::noArray(), corners, rows);
  OrbFeatures found;
  found.corners.reserve(corners.size());
  found.descriptors.resize(corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const cv::KeyPoint& corner = corners[i];
    found.corners.push_back({corner.pt.x, corner.pt.y, corner.size, corner.angle});
    std::memcpy(found.descriptors[i].data(), rows.ptr(static_cast<int>(i)),
                sizeof(BinaryDescriptor));
  }
  return found;
}

}  // namespace bulletnav::agent
