// SPDX-License-Identifier: MIT
#include "sim/image/image.h"

#include <algorithm>
#include <cmath>

#include "sim/base/error.h"
#include "sim/base/files.h"
#include "sim/image/codecs.h"

namespace bulletnav::sim {
namespace {

/// Which source pixels, and how much of each, make one target pixel along one axis.
struct Taps {
  int first = 0;
  std::vector<float> weights;
};

std::vector<Taps> BoxFilter(int from, int to) {
  std::vector<Taps> all;
  const double ratio = static_cast<double>(from) / to;
  for (int i = 0; i < to; ++i) {
    // A target narrower than a source pixel takes a window of one pixel around its centre.
    const double centre = (i + 0.5) * ratio;
    const double half = 0.5 * std::max(1.0, ratio);
    const double low = std::max(0.0, centre - half);
    const double high = std::min<double>(from, centre + half);
    Taps taps;
    taps.first = static_cast<int>(low);
    const int last = std::min(from - 1, static_cast<int>(std::ceil(high)) - 1);
    double total = 0.0;
    for (int j = taps.first; j <= last; ++j) {
      const double share = std::min<double>(high, j + 1) - std::max<double>(low, j);
      taps.weights.push_back(static_cast<float>(share));
      total += share;
    }
    for (float& w : taps.weights) w = static_cast<float>(w / total);
    all.push_back(std::move(taps));
  }
  return all;
}

/// Mean of each 2 x 2 pixels; the common case, many times faster than the general filter.
Image Halve(const Image& image) {
  Image half(image.width / 2, image.height / 2, image.channels);
  const auto channels = static_cast<std::size_t>(image.channels);
  for (int y = 0; y < half.height; ++y) {
    const std::uint8_t* above = image.at(0, 2 * y);
    const std::uint8_t* below = image.at(0, 2 * y + 1);
    std::uint8_t* out = half.at(0, y);
    for (int x = 0; x < half.width; ++x) {
      for (std::size_t c = 0; c < channels; ++c) {
        const int sum = above[c] + above[channels + c] + below[c] + below[channels + c];
        *out++ = static_cast<std::uint8_t>((sum + 2) / 4);
      }
      above += 2 * channels;
      below += 2 * channels;
    }
  }
  return half;
}

}  // namespace

Image DecodeImage(std::span<const std::uint8_t> bytes) {
  if (bytes.size() >= 8 && bytes[0] == 0x89 && bytes[1] == 'P') return DecodePng(bytes);
  if (bytes.size() >= 3 && bytes[0] == 0xff && bytes[1] == 0xd8) return DecodeJpeg(bytes);
  return DecodeWithStb(bytes);
}

void WritePng(const std::filesystem::path& file, const Image& image) {
  WriteFileAtomically(file, EncodePng(image));
}

Image Resize(const Image& image, int width, int height) {
  if (width <= 0 || height <= 0 || image.width <= 0 || image.height <= 0) {
    throw Error("only pictures with pixels can be resized, to sizes above 0");
  }
  if (image.width == width && image.height == height) return image;
  if (image.width % 2 == 0 && image.height % 2 == 0 && image.width >= 2 * width &&
      image.height >= 2 * height) {
    return Resize(Halve(image), width, height);
  }
  const std::vector<Taps> columns = BoxFilter(image.width, width);
  const std::vector<Taps> rows = BoxFilter(image.height, height);
  const auto channels = static_cast<std::size_t>(image.channels);
  const std::size_t row_size = static_cast<std::size_t>(width) * channels;
  std::vector<float> narrowed(row_size * static_cast<std::size_t>(image.height), 0.0f);
  for (int y = 0; y < image.height; ++y) {
    float* out = &narrowed[row_size * static_cast<std::size_t>(y)];
    for (const Taps& taps : columns) {
      const std::uint8_t* in = image.at(taps.first, y);
      for (const float w : taps.weights) {
        for (std::size_t c = 0; c < channels; ++c) out[c] += w * static_cast<float>(*in++);
      }
      out += channels;
    }
  }
  Image result(width, height, image.channels);
  std::vector<float> sum(row_size);
  for (int y = 0; y < height; ++y) {
    const Taps& taps = rows[static_cast<std::size_t>(y)];
    std::fill(sum.begin(), sum.end(), 0.5f);
    for (std::size_t k = 0; k < taps.weights.size(); ++k) {
      const float* in = &narrowed[row_size * (static_cast<std::size_t>(taps.first) + k)];
      for (std::size_t i = 0; i < row_size; ++i) sum[i] += taps.weights[k] * in[i];
    }
    std::uint8_t* out = result.at(0, y);
    for (std::size_t i = 0; i < row_size; ++i) {
      out[i] = static_cast<std::uint8_t>(std::clamp(sum[i], 0.0f, 255.0f));
    }
  }
  return result;
}

}  // namespace bulletnav::sim
