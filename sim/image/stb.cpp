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

Image DecodeWithStb(std::span<const std::uint8_t> bytes) {
  if (bytes.size() > INT_MAX) throw ImageError("picture file over 2 GB");
  const int size = static_cast<int>(bytes.size());
  int width = 0;
  int height = 0;
  int channels = 0;
  if (stbi_info_from_memory(bytes.data(), size, &width, &height, &channels) == 0) {
    throw ImageError("not a PNG, JPEG, BMP or TGA picture");
  }
  if (width <= 0 || height <= 0 || std::uint64_t(width) * std::uint64_t(height) > kMaxImagePixels) {
    throw ImageError("more than 64 million pixels");
  }
  const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> pixels(
      stbi_load_from_memory(bytes.data(), size, &width, &height, &channels, 4), stbi_image_free);
  if (!pixels) throw ImageError(std::string("damaged picture: ") + stbi_failure_reason());
  Image image(width, height, 4);
  std::copy_n(pixels.get(), image.pixels.size(), image.pixels.begin());
  return image;
}

}  // namespace bulletnav::sim
