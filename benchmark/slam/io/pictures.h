// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "sim/image/image.h"

namespace bulletnav::bench {

/// Depth along the camera's axis in metres, row by row, 0 where there is none.
struct DepthPicture {
  int width = 0;
  int height = 0;
  std::vector<float> metres;
};

/// The RGB of a picture file. Throws sim::FileError if it is not there or damaged.
sim::Image ReadRgb(const std::filesystem::path& file);

/// 16-bit grey PNGs of so many units a metre: 5000 in TUM's folders, 256 in KITTI's. What does not
/// fit is written as none. Reading throws sim::FileError for other files, and writing if it fails.
DepthPicture ReadDepth(const std::filesystem::path& file, double units_a_metre);
void WriteDepth(const std::filesystem::path& file, const DepthPicture& picture,
                double units_a_metre);

/// What a frame's pictures are called in the folders of recordings that are written here.
std::string PictureName(std::size_t frame);
/// Removes from `folders` the pictures of this frame and those after it: what an import into the
/// same place left that did not come to its end.
void RemovePicturesFrom(std::size_t frame, std::span<const std::filesystem::path> folders);

}  // namespace bulletnav::bench
