// SPDX-License-Identifier: MIT
#include "agent/slam/descriptors/shrink_picture.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>

#include "sim/base/error.h"

namespace bulletnav::agent {
namespace {

constexpr std::int64_t kLargest = 254;  // for 255
constexpr std::int64_t kWhite = 255;

/// What of each cell's stretch each pixel covers, in 1/cells of a pixel.
struct Share {
  int pixel = 0;
  std::int64_t share = 0;
};

std::vector<std::vector<Share>> SharesOf(int cells, int pixels) {
  std::vector<std::vector<Share>> shares(static_cast<std::size_t>(cells));
  for (int cell = 0; cell < cells; ++cell) {
    const std::int64_t first = std::int64_t{cell} * pixels;
    const std::int64_t last = first + pixels;
    for (std::int64_t pixel = first / cells; pixel * cells < last; ++pixel) {
      const std::int64_t share =
          std::min(last, (pixel + 1) * cells) - std::max(first, pixel * cells);
      shares[static_cast<std::size_t>(cell)].push_back({static_cast<int>(pixel), share});
    }
  }
  return shares;
}

/// Red, green and blue.
std::array<std::int64_t, 3> SumsOf(const std::vector<Share>& cols,
                                   const std::vector<std::int64_t>& columns) {
  std::array<std::int64_t, 3> sums{};
  for (const Share& col : cols) {
    const std::int64_t* from = columns.data() + static_cast<std::size_t>(col.pixel) * 3;
    for (std::size_t i = 0; i < 3; ++i) sums[i] += col.share * from[i];
  }
  return sums;
}

/// Sums in shares of `whole`, which is kLargest, rounded.
std::array<std::uint8_t, 3> ShareOf(const std::array<std::int64_t, 3>& sums, std::int64_t whole) {
  std::array<std::uint8_t, 3> shares{};
  for (std::size_t i = 0; i < 3; ++i) {
    shares[i] = static_cast<std::uint8_t>((2 * kLargest * sums[i] + whole) / (2 * whole));
  }
  return shares;
}

}  // namespace

std::vector<std::uint8_t> ShrinkPicture(std::span<const std::uint8_t> rgb, int width_px,
                                        int height_px, int rows, int cols) {
  const std::string size = std::to_string(width_px) + " x " + std::to_string(height_px);
  if (width_px < cols || height_px < rows) {
    throw sim::Error("a picture of " + size + " is too small; give at least " +
                     std::to_string(cols) + " x " + std::to_string(rows) + " pixels");
  }
  if (rgb.size() != static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px) * 3) {
    throw sim::Error("a picture of " + size + " cannot have " + std::to_string(rgb.size()) +
                     " bytes of RGB; give three a pixel");
  }
  const auto across = SharesOf(cols, width_px);
  const auto down = SharesOf(rows, height_px);
  const std::int64_t whole = std::int64_t{width_px} * height_px * kWhite;
  std::vector<std::uint8_t> out;
  out.reserve(static_cast<std::size_t>(rows) * static_cast<std::size_t>(cols) * 3);
  std::vector<std::int64_t> columns(static_cast<std::size_t>(width_px) * 3);  // summed over rows
  for (const auto& rows_of : down) {
    std::fill(columns.begin(), columns.end(), 0);
    for (const Share& row : rows_of) {
      const std::uint8_t* from = rgb.data() + static_cast<std::size_t>(row.pixel) * columns.size();
      for (std::size_t i = 0; i < columns.size(); ++i) columns[i] += row.share * from[i];
    }
    for (const auto& cols_of : across) {
      const auto color = ShareOf(SumsOf(cols_of, columns), whole);
      out.insert(out.end(), color.begin(), color.end());
    }
  }
  return out;
}

}  // namespace bulletnav::agent
