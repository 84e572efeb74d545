// SPDX-License-Identifier: MIT
#include "agent/slam/features/stereo.h"

#include <cstddef>

#include <fmt/core.h>
#include <opencv2/calib3d.hpp>

#include "agent/slam/features/grey.h"
#include "sim/base/error.h"

namespace bulletnav::agent {

void StereoSpec::Validate() const {
  if (disparities < 16 || disparities % 16 != 0 || block_px < 1 || block_px % 2 == 0) {
    throw sim::Error("expected disparities that are a multiple of 16, and an odd block_px");
  }
  if (!(fx > 0.0 && baseline_m > 0.0)) throw sim::Error("fx and baseline_m must be positive");
}

std::vector<float> StereoDepth(std::span<const std::uint8_t> left,
                               std::span<const std::uint8_t> right, int width_px, int height_px,
                               const StereoSpec& spec) {
  spec.Validate();
  if (width_px <= spec.disparities) {
    throw sim::Error(
        fmt::format("pictures of {} x {} pixels are too narrow for stereo, which tries "
                    "{} columns; take wider ones",
                    width_px, height_px, spec.disparities));
  }
  const cv::Mat a = GreyOf(left, width_px, height_px);
  const cv::Mat b = GreyOf(right, width_px, height_px);
  // Penalties of small and large steps as OpenCV advises; unsure pixels are left out.
  const int area = spec.block_px * spec.block_px;
  constexpr int kLeftRight = 1;
  constexpr int kUnique = 10;
  constexpr int kSpeckle = 100;
  const auto matcher =
      cv::StereoSGBM::create(0, spec.disparities, spec.block_px, 8 * area, 32 * area, kLeftRight, 0,
                             kUnique, kSpeckle, 2, cv::StereoSGBM::MODE_SGBM_3WAY);
  cv::Mat disparity;  // 16 a pixel
  matcher->compute(a, b, disparity);
  std::vector<float> depth;
  depth.reserve(static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px));
  for (int row = 0; row < height_px; ++row) {
    for (int col = 0; col < width_px; ++col) {
      const double pixels = disparity.at<std::int16_t>(row, col) / 16.0;
      depth.push_back(pixels > 0.0 ? static_cast<float>(spec.fx * spec.baseline_m / pixels) : 0.0F);
    }
  }
  return depth;
}

}  // namespace bulletnav::agent
