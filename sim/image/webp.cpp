// SPDX-License-Identifier: MIT
#include <webp/decode.h>

#include "sim/image/codecs.h"

namespace bulletnav::sim {

Image DecodeWebp(std::span<const std::uint8_t> bytes, std::uint64_t most_pixels) {
  WebPDecoderConfig config;
  if (WebPInitDecoderConfig(&config) == 0) throw ImageError("libwebp is of another version");
  if (WebPGetFeatures(bytes.data(), bytes.size(), &config.input) != VP8_STATUS_OK) {
    throw ImageError("damaged WebP: its header cannot be read");
  }
  if (config.input.has_animation != 0) throw ImageError("WebP films are not read; take a picture");
  const auto width = static_cast<std::uint64_t>(config.input.width);
  const auto height = static_cast<std::uint64_t>(config.input.height);
  const int shrink = ShrinkOf(width, height, most_pixels);
  Image image(Shrunk(width, shrink), Shrunk(height, shrink), 4);
  config.options.use_scaling = shrink > 1 ? 1 : 0;
  config.options.scaled_width = image.width;
  config.options.scaled_height = image.height;
  config.output.colorspace = MODE_RGBA;
  config.output.is_external_memory = 1;
  config.output.u.RGBA.rgba = image.pixels.data();
  config.output.u.RGBA.stride = 4 * image.width;
  config.output.u.RGBA.size = image.pixels.size();
  if (WebPDecode(bytes.data(), bytes.size(), &config) != VP8_STATUS_OK) {
    throw ImageError("damaged WebP: it cannot be decoded to its end");
  }
  return image;
}

}  // namespace bulletnav::sim
