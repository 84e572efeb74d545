// SPDX-License-Identifier: MIT
#include "agent/integer/pictures.h"

#include <algorithm>
#include <cstring>

#include "agent/integer/kernels/kernels.h"
#include "sim/base/check.h"

namespace bulletnav::agent {
namespace {

/// out[i] = the largest of a, b and c.
void LargestOf(const std::uint8_t* a, const std::uint8_t* b, const std::uint8_t* c, int count,
               std::uint8_t* out) {
  for (int i = 0; i < count; ++i) {
    const std::uint8_t larger = a[i] > b[i] ? a[i] : b[i];
    out[i] = larger > c[i] ? larger : c[i];
  }
}

}  // namespace

void Pictures::JoinEnds(int pictures) {
  const int side = shape.border * shape.channels;
  const int inside = shape.cols * shape.channels;
  for (int picture = 0; picture < pictures; ++picture) {
    for (int row = 0; row < shape.rows; ++row) {
      std::uint8_t* first =
          bytes.data() + std::ptrdiff_t{picture} * shape.size() + shape.Offset(row, 0);
      for (int i = 0; i < side; ++i) {
        // Borders may be wider than the picture.
        first[-1 - i] = first[inside - 1 - i % inside];
        first[inside + i] = first[i % inside];
      }
    }
  }
}

std::vector<std::int32_t> PixelOffsets(const PictureShape& shape, int count, int step, int ahead) {
  std::vector<std::int32_t> offsets;
  offsets.reserve(static_cast<std::size_t>(count) * static_cast<std::size_t>(shape.rows / step) *
                  static_cast<std::size_t>(shape.cols / step));
  for (int picture = 0; picture < count; ++picture) {
    for (int row = 0; row < shape.rows; row += step) {
      for (int col = 0; col < shape.cols; col += step) {
        offsets.push_back(picture * shape.size() + shape.Offset(row - ahead, col - ahead));
      }
    }
  }
  return offsets;
}

void PoolLargest(const Pictures& in, int pictures, Pictures* out, std::vector<std::int16_t>* fine) {
  const PictureShape& from = in.shape;
  const PictureShape& to = out->shape;
  BULLETNAV_CHECK_EQ(from.rows, 2 * to.rows);
  BULLETNAV_CHECK_EQ(from.cols, 2 * to.cols);
  BULLETNAV_CHECK_EQ(from.channels, to.channels);
  BULLETNAV_CHECK(from.border >= 1);
  const int channels = from.channels;
  std::vector<std::uint8_t> columns(static_cast<std::size_t>((from.cols + 2) * channels));
  std::size_t at = 0;
  for (int picture = 0; picture < pictures; ++picture) {
    const std::uint8_t* source = in.bytes.data() + std::ptrdiff_t{picture} * from.size();
    std::uint8_t* target = out->bytes.data() + std::ptrdiff_t{picture} * to.size();
    for (int row = 0; row < to.rows; ++row) {
      const std::uint8_t* middle = source + from.Offset(2 * row, -1);
      LargestOf(middle - from.row_stride(), middle, middle + from.row_stride(),
                (from.cols + 2) * channels, columns.data());
      for (int col = 0; col < to.cols; ++col) {
        const std::uint8_t* left = columns.data() + 2 * col * channels;
        std::uint8_t* pixel = target + to.Offset(row, col);
        LargestOf(left, left + channels, left + 2 * channels, channels, pixel);
        for (int i = 0; i < channels; ++i) {
          (*fine)[at++] = static_cast<std::int16_t>(pixel[i] << kFineBits);
        }
      }
    }
  }
}

}  // namespace bulletnav::agent
