// SPDX-License-Identifier: MIT
#include "sim/image/codecs.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wall"
#pragma GCC diagnostic ignored "-Wextra"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wconversion"
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_BMP
#define STBI_ONLY_TGA
#define STBI_NO_STDIO
#include <stb/stb_image.h>
#pragma GCC diagnostic pop

#include <algorithm>
#include <climits>
#include <memory>

namespace bulletnav::sim {

Image DecodeWithStb(std::span<const std::uint8_t> bytes, std::uint64_t most_pixels) {
  if (bytes.size() > INT_MAX) throw ImageError("picture file over 2 GB");
  const int size = static_cast<int>(bytes.size());
  int width = 0;
  int height = 0;
  int channels = 0;
  if (stbi_info_from_memory(bytes.data(), size, &width, &height, &channels) == 0) {
    throw ImageError("not a PNG, JPEG, WebP, BMP or TGA picture");
  }
  const int shrink = ShrinkOf(static_cast<std::uint64_t>(std::max(0, width)),
                              static_cast<std::uint64_t>(std::max(0, height)), most_pixels);
  const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> pixels(
      stbi_load_from_memory(bytes.data(), size, &width, &height, &channels, 4), stbi_image_free);
  if (!pixels) throw ImageError(std::string("damaged picture: ") + stbi_failure_reason());
  const std::size_t row_size = 4 * static_cast<std::size_t>(width);
  RowAverager rows(width, height, shrink);
  for (int y = 0; y < height; ++y) {
    rows.Add({pixels.get() + row_size * static_cast<std::size_t>(y), row_size});
  }
  return rows.Take();
}

}  // namespace bulletnav::sim
