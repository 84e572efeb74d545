// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

namespace bulletnav::agent {

/// The size of pictures with a border on all sides, for windows that reach over their edges.
struct PictureShape {
  int rows = 0;
  int cols = 0;
  int channels = 0;
  int border = 0;

  int row_stride() const { return (cols + 2 * border) * channels; }
  int size() const { return (rows + 2 * border) * row_stride(); }
  /// Of a pixel's first channel; rows and columns of the border are negative, or beyond.
  int Offset(int row, int col) const {
    return (row + border) * row_stride() + (col + border) * channels;
  }
};

/// Several pictures of bytes, one after the other: [rows, cols, channels], borders around each.
struct Pictures {
  PictureShape shape;
  int count = 0;
  std::vector<std::uint8_t> bytes;

  /// All bytes, of borders as well, are `fill`.
  Pictures(const PictureShape& shape_in, int count_in, std::uint8_t fill = 0)
      : shape(shape_in),
        count(count_in),
        bytes(static_cast<std::size_t>(shape_in.size()) * static_cast<std::size_t>(count_in),
              fill) {}

  /// Sets the border's columns beside the rows: the ends of the first `pictures` meet. Rows above
  /// and below keep what they were filled with.
  void JoinEnds(int pictures);
};

/// [pictures * rows * cols] offsets of all pixels; `step` pixels apart, `ahead` up and to the left.
std::vector<std::int32_t> PixelOffsets(const PictureShape& shape, int count, int step = 1,
                                       int ahead = 0);

/// The largest of 3 x 3 pixels around each second one, as a convolution of stride 2 with a border
/// of 1 counts them, of the first `pictures` of `in`. `out` has half the rows and columns; `fine`
/// [pictures, rows, cols, channels] gets the same, 128 times as large. Expects: shapes that agree
/// (checked).
void PoolLargest(const Pictures& in, int pictures, Pictures* out, std::vector<std::int16_t>* fine);

}  // namespace bulletnav::agent
