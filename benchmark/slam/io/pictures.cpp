// SPDX-License-Identifier: MIT
#include "benchmark/slam/io/pictures.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>

#include <fmt/core.h>

#include "sim/base/error.h"
#include "sim/base/files.h"

namespace bulletnav::bench {

sim::Image ReadRgb(const std::filesystem::path& file) {
  sim::Image picture;
  try {
    picture = sim::DecodeImage(sim::ReadFile(file));
  } catch (const sim::ImageError& e) {
    throw sim::FileError(file, "", std::string(e.what()) + "; leave the frame out or mend it");
  }
  sim::Image color(picture.width, picture.height, 3);
  for (std::size_t i = 0; i < color.pixels.size(); ++i) {
    color.pixels[i] = picture.pixels[i / 3 * 4 + i % 3];
  }
  return color;
}

DepthPicture ReadDepth(const std::filesystem::path& file, double units_a_metre) {
  DepthPicture picture;
  const std::vector<std::uint8_t> bytes = sim::ReadFile(file);
  try {
    const auto values = sim::DecodePng16(bytes, &picture.width, &picture.height);
    picture.metres.reserve(values.size());
    for (const std::uint16_t value : values) {
      picture.metres.push_back(static_cast<float>(value / units_a_metre));
    }
  } catch (const sim::ImageError& e) {
    throw sim::FileError(
        file, "",
        fmt::format("{}; depth is a 16-bit grey PNG of {} a metre", e.what(), units_a_metre));
  }
  return picture;
}

void WriteDepth(const std::filesystem::path& file, const DepthPicture& picture,
                double units_a_metre) {
  std::vector<std::uint16_t> values;
  values.reserve(picture.metres.size());
  for (const float metres : picture.metres) {
    const double units = std::round(metres * units_a_metre);
    const bool fits = units > 0.0 && units <= std::numeric_limits<std::uint16_t>::max();
    values.push_back(fits ? static_cast<std::uint16_t>(units) : std::uint16_t{0});
  }
  sim::WriteFileAtomically(file, sim::EncodePng16(values, picture.width, picture.height));
}

std::string PictureName(std::size_t frame) {
  return fmt::format("{:06}.png", frame);
}

void RemovePicturesFrom(std::size_t frame, std::span<const std::filesystem::path> folders) {
  for (bool found = true; found; ++frame) {
    found = false;
    for (const std::filesystem::path& folder : folders) {
      std::error_code ignored;  // what stays is in no list
      found = std::filesystem::remove(folder / PictureName(frame), ignored) || found;
    }
  }
}

}  // namespace bulletnav::bench
