// SPDX-License-Identifier: MIT
#include "sim/image/image.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>

#include "sim/base/error.h"
#include "sim/base/files.h"
#include "sim/base/lower_case.h"
#include "sim/image/codecs.h"
#include "sim/image/decode.h"

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

/// Mean of each 2 x 2 pixels of two rows.
void HalveRows(const std::uint8_t* above, const std::uint8_t* below, std::size_t channels,
               std::span<std::uint8_t> out) {
  for (std::size_t i = 0; i < out.size(); i += channels) {
    for (std::size_t c = 0; c < channels; ++c) {
      const int sum = above[c] + above[channels + c] + below[c] + below[channels + c];
      out[i + c] = static_cast<std::uint8_t>((sum + 2) / 4);
    }
    above += 2 * channels;
    below += 2 * channels;
  }
}

/// The common case, many times faster than the general filter.
Image Halve(const Image& image) {
  Image half(image.width / 2, image.height / 2, image.channels);
  const auto channels = static_cast<std::size_t>(image.channels);
  const std::size_t row_size = static_cast<std::size_t>(half.width) * channels;
  for (int y = 0; y < half.height; ++y) {
    HalveRows(image.at(0, 2 * y), image.at(0, 2 * y + 1), channels, {half.at(0, y), row_size});
  }
  return half;
}

/// One row in other columns: sums of `in` by the columns' weights are added to `out`.
void NarrowRow(const Image& image, int y, std::span<const Taps> columns, float* out) {
  const auto channels = static_cast<std::size_t>(image.channels);
  for (const Taps& taps : columns) {
    const std::uint8_t* in = image.at(taps.first, y);
    for (const float w : taps.weights) {
      for (std::size_t c = 0; c < channels; ++c) out[c] += w * static_cast<float>(*in++);
    }
    out += channels;
  }
}

struct Unread {
  std::string_view name;
  std::size_t at;  // where the text is in its files
  std::string_view text;
  std::string_view ending;  // of their names
};
constexpr std::array<Unread, 5> kUnread = {{{kKtx, 0, "\xabKTX ", ".ktx2"},
                                            {kKtx, 0, "\xabKTX ", ".ktx"},
                                            {"Basis Universal (.basis)", 0, "sB", ".basis"},
                                            {"DDS", 0, "DDS ", ".dds"},
                                            {"AVIF", 4, "ftypavi", ".avif"}}};

bool HasText(std::span<const std::uint8_t> bytes, std::size_t at, std::string_view text) {
  return bytes.size() >= at + text.size() &&
         std::equal(text.begin(), text.end(), bytes.begin() + static_cast<std::ptrdiff_t>(at),
                    [](char a, std::uint8_t b) {
                      return static_cast<std::uint8_t>(a) == b;
                    });
}

}  // namespace

std::string_view UnreadFormat(std::span<const std::uint8_t> bytes) {
  for (const Unread& format : kUnread) {
    if (HasText(bytes, format.at, format.text)) return format.name;
  }
  return {};
}

std::string_view UnreadFormat(const std::filesystem::path& file) {
  const std::string ending = LowerCase(file.extension().string());
  for (const Unread& format : kUnread) {
    if (ending == format.ending) return format.name;
  }
  return {};
}

Image DecodeImage(std::span<const std::uint8_t> bytes) {
  return DecodeImage(bytes, kMostKeptPixels);
}

Image DecodeImage(std::span<const std::uint8_t> bytes, std::uint64_t most_pixels) {
  if (HasText(bytes, 0, "\x89P")) return DecodePng(bytes, most_pixels);
  if (HasText(bytes, 0, "\xff\xd8")) return DecodeJpeg(bytes, most_pixels);
  if (HasText(bytes, 0, "RIFF") && HasText(bytes, 8, "WEBP")) {
    return DecodeWebp(bytes, most_pixels);
  }
  const std::string_view unread = UnreadFormat(bytes);
  if (!unread.empty()) {
    throw ImageError("is in " + std::string(unread) +
                     ", which is not read; convert it to PNG or JPEG");
  }
  return DecodeWithStb(bytes, most_pixels);
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
  const std::size_t row_size =
      static_cast<std::size_t>(width) * static_cast<std::size_t>(image.channels);
  std::vector<float> narrowed(row_size * static_cast<std::size_t>(image.height), 0.0f);
  for (int y = 0; y < image.height; ++y) {
    NarrowRow(image, y, columns, &narrowed[row_size * static_cast<std::size_t>(y)]);
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
