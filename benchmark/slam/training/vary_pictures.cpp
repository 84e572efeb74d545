// SPDX-License-Identifier: MIT
#include "benchmark/slam/training/vary_pictures.h"

#include <algorithm>
#include <cstddef>
#include <span>

#include "benchmark/slam/training/place_views.h"
#include "sim/base/check.h"

namespace bulletnav::bench {
namespace {

sim::PinholeSpec CameraOf(int rows) {
  sim::PinholeSpec camera;
  camera.rows = rows;
  camera.cols = rows * kViewCols / kViewRows;
  return camera;
}

void Mirror(std::size_t cols, std::span<std::uint8_t> picture) {
  for (std::size_t row = 0; row < picture.size(); row += 3 * cols) {
    const auto line = picture.subspan(row, 3 * cols);
    std::reverse(line.begin(), line.end());
    // Pixels are the other way round now, and so are the channels of each.
    for (std::size_t i = 0; i < line.size(); i += 3) std::swap(line[i], line[i + 2]);
  }
}

}  // namespace

void VaryPictures(const PictureAugmentSpec& spec, const sim::Rng& rng, int rows,
                  std::vector<std::uint8_t>* pictures) {
  const sim::PinholeSpec camera = CameraOf(rows);
  const std::size_t size = camera.pixels() * 3;
  BULLETNAV_CHECK_EQ(pictures->size() % size, 0u);
  const bool mirrors = rng.Fork("mirror").Chance(spec.mirrored);
  for (std::size_t i = 0; i < pictures->size() / size; ++i) {
    const auto picture = std::span(*pictures).subspan(i * size, size);
    sim::Rng own = rng.Fork("picture", i);
    if (mirrors) Mirror(static_cast<std::size_t>(camera.cols), picture);
    Recolor(spec.color(), &own, picture);
    AddSensorNoise(spec.sensor_noise, spec.noise_strength, camera, own, picture, {});
  }
}

}  // namespace bulletnav::bench
