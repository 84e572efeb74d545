// SPDX-License-Identifier: MIT
#include "agent/slam/features/grey.h"

#include <cstddef>
#include <cstring>
#include <string>

#include <opencv2/imgproc.hpp>

#include "sim/base/error.h"

namespace bulletnav::agent {
namespace {

/// OpenCV's own threads would only get in the way of ours.
void StayInThisThread() {
  if (cv::getNumThreads() != 1) cv::setNumThreads(1);
}

}  // namespace

cv::Mat GreyOf(std::span<const std::uint8_t> rgb, int width_px, int height_px) {
  StayInThisThread();
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

OrbFeatures FeaturesOf(const std::vector<cv::KeyPoint>& corners, const cv::Mat& rows) {
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
