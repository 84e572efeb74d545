// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace bulletnav::sim {

/// 8-bit picture, rows from the top, channels interleaved: 1 grey, 3 RGB, 4 RGBA (sRGB colour).
struct Image {
  int width = 0;
  int height = 0;
  int channels = 0;
  std::vector<std::uint8_t> pixels;  // [height, width, channels]

  Image() = default;
  Image(int w, int h, int c)
      : width(w),
        height(h),
        channels(c),
        pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h) *
               static_cast<std::size_t>(c)) {}

  std::uint8_t* at(int x, int y) {
    return &pixels[(static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                    static_cast<std::size_t>(x)) *
                   static_cast<std::size_t>(channels)];
  }
  const std::uint8_t* at(int x, int y) const { return const_cast<Image*>(this)->at(x, y); }
};

/// A picture that cannot be decoded; callers add the file's name and place.
class ImageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Decodes PNG, JPEG, WebP, BMP or TGA into RGBA, large pictures as sim/image/decode.h says.
/// Throws ImageError: unknown or damaged format, or more than 16,384 x 16,384 pixels.
Image DecodeImage(std::span<const std::uint8_t> bytes);

/// PNG of a 1, 3 or 4 channel picture.
std::vector<std::uint8_t> EncodePng(const Image& image);

/// 16-bit grey PNG; `values` holds height rows of width.
std::vector<std::uint8_t> EncodePng16(std::span<const std::uint16_t> values, int width, int height);

/// Decodes a 16-bit grey PNG made by EncodePng16. Throws ImageError.
std::vector<std::uint16_t> DecodePng16(std::span<const std::uint8_t> bytes, int* width,
                                       int* height);

/// JPEG of an RGB picture; quality 1 to 100, no chroma subsampling.
std::vector<std::uint8_t> EncodeJpeg(const Image& image, int quality);

/// Writes a PNG atomically. Throws FileError.
void WritePng(const std::filesystem::path& file, const Image& image);

/// Box-filtered resize of a picture to any size, in stored (gamma) values.
Image Resize(const Image& image, int width, int height);

}  // namespace bulletnav::sim
