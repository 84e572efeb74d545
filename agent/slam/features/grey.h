// SPDX-License-Identifier: MIT
// For the files of this folder that know OpenCV.
#pragma once
#include <cstdint>
#include <span>

#include <opencv2/core.hpp>

#include "agent/slam/features/orb.h"

namespace bulletnav::agent {

/// The grey picture of an RGB one; from here on OpenCV stays in the calling thread. Throws
/// sim::Error if the picture has not as many bytes as its size says.
cv::Mat GreyOf(std::span<const std::uint8_t> rgb, int width_px, int height_px);

/// OpenCV's corners with a descriptor a row as ours.
OrbFeatures FeaturesOf(const std::vector<cv::KeyPoint>& corners, const cv::Mat& rows);

}  // namespace bulletnav::agent
