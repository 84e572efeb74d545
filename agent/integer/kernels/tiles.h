// SPDX-License-Identifier: MIT
#pragma once
// Products of whole matrices by Intel's AMX: 16 pixels x 16 outputs at a time. Only kernel files
// include this; see lanes.h for what that means.
#include <cstdint>

#include <immintrin.h>

#include "agent/integer/kernels/kernels.h"

namespace bulletnav::agent {
namespace {

constexpr std::int32_t kTileRows = 16;    // pixels; words of a weights' tile
constexpr std::int32_t kMostWords = 640;  // of a pixel; longer jobs are for the other kernels

/// Shapes of the tiles: 0 to 3 sums, 4 inputs, 5 weights.
struct alignas(64) TileShapes {
  std::uint8_t palette = 1;
  std::uint8_t start_row = 0;
  std::uint8_t reserved[14] = {};
  std::uint16_t row_bytes[16] = {};
  std::uint8_t rows[16] = {};
};
static_assert(sizeof(TileShapes) == 64);

inline void ShapeTiles(std::int32_t pixels, std::int32_t words) {
  TileShapes shapes;
  for (int sums = 0; sums < 4; ++sums) {
    shapes.rows[sums] = static_cast<std::uint8_t>(pixels);
    shapes.row_bytes[sums] = 4 * kOutputBlock;
  }
  shapes.rows[4] = static_cast<std::uint8_t>(pixels);
  shapes.row_bytes[4] = static_cast<std::uint16_t>(4 * words);
  shapes.rows[5] = static_cast<std::uint8_t>(words);
  shapes.row_bytes[5] = 4 * kOutputBlock;
  _tile_loadconfig(&shapes);
}

/// The most words that fit into a tile and divide `words`.
inline std::int32_t WordsAtATime(std::int32_t words) {
  std::int32_t at_a_time = words < kTileRows ? words : kTileRows;
  while (words % at_a_time != 0) --at_a_time;
  return at_a_time;
}

/// Copies the segments of a pixel one after the other.
inline void JoinSegments(const DotJob& job, const std::uint8_t* in, std::int32_t* out) {
  for (std::int32_t segment = 0; segment < job.segments; ++segment, out += job.steps) {
    const std::uint8_t* from = in + std::int64_t{segment} * job.segment_stride;
    std::int32_t word = 0;
    for (; word + 16 <= job.steps; word += 16) {
      _mm512_storeu_si512(out + word, _mm512_loadu_si512(from + std::int64_t{4} * word));
    }
    const auto rest = static_cast<__mmask16>((1u << (job.steps - word)) - 1);
    _mm512_mask_storeu_epi32(out + word, rest,
                             _mm512_maskz_loadu_epi32(rest, from + std::int64_t{4} * word));
  }
}

/// kBlocks blocks of outputs from `block` on, of the pixels from `first` on for which the tiles are
/// shaped. `in`: their words, `words` each.
template <int kBlocks>
inline void MultiplyTiles(const DotJob& job, const std::int32_t* in, std::int32_t words,
                          std::int32_t at_a_time, std::int32_t first, std::int32_t block) {
  const std::int32_t* weights = job.weights + std::int64_t{words} * kOutputBlock * block;
  const std::int64_t apart = std::int64_t{words} * kOutputBlock;
  const std::int64_t outputs = std::int64_t{job.blocks} * kOutputBlock;
  _tile_zero(0);
  if constexpr (kBlocks > 1) _tile_zero(1);
  if constexpr (kBlocks > 2) _tile_zero(2);
  if constexpr (kBlocks > 3) _tile_zero(3);
  for (std::int32_t word = 0; word < words; word += at_a_time) {
    const std::int32_t* rows = weights + std::int64_t{word} * kOutputBlock;
    _tile_loadd(4, in + word, std::int64_t{4} * words);
    _tile_loadd(5, rows, 64);
    _tile_dpbusd(0, 4, 5);
    if constexpr (kBlocks > 1) {
      _tile_loadd(5, rows + apart, 64);
      _tile_dpbusd(1, 4, 5);
    }
    if constexpr (kBlocks > 2) {
      _tile_loadd(5, rows + 2 * apart, 64);
      _tile_dpbusd(2, 4, 5);
    }
    if constexpr (kBlocks > 3) {
      _tile_loadd(5, rows + 3 * apart, 64);
      _tile_dpbusd(3, 4, 5);
    }
  }
  std::int32_t* out = job.sums + first * outputs + block * kOutputBlock;
  _tile_stored(0, out, 4 * outputs);
  if constexpr (kBlocks > 1) _tile_stored(1, out + kOutputBlock, 4 * outputs);
  if constexpr (kBlocks > 2) _tile_stored(2, out + 2 * kOutputBlock, 4 * outputs);
  if constexpr (kBlocks > 3) _tile_stored(3, out + 3 * kOutputBlock, 4 * outputs);
}

inline bool FitsTiles(const DotJob& job) {
  return job.segments * job.steps <= kMostWords;
}

void RunDotTiles(const DotJob& job) {
  const std::int32_t words = job.segments * job.steps;
  const std::int32_t at_a_time = WordsAtATime(words);
  alignas(64) std::int32_t in[kTileRows * kMostWords];
  std::int32_t shaped = 0;  // for so many pixels
  for (std::int32_t first = 0; first < job.pixels; first += kTileRows) {
    const std::int32_t count = job.pixels - first < kTileRows ? job.pixels - first : kTileRows;
    if (count != shaped) ShapeTiles(count, at_a_time);
    shaped = count;
    for (std::int32_t pixel = 0; pixel < count; ++pixel) {
      JoinSegments(job, job.in + job.offsets[first + pixel], in + std::int64_t{pixel} * words);
    }
    std::int32_t block = 0;
    for (; block + 4 <= job.blocks; block += 4) {
      MultiplyTiles<4>(job, in, words, at_a_time, first, block);
    }
    for (; block + 2 <= job.blocks; block += 2) {
      MultiplyTiles<2>(job, in, words, at_a_time, first, block);
    }
    for (; block < job.blocks; ++block) MultiplyTiles<1>(job, in, words, at_a_time, first, block);
  }
  _tile_release();
}

}  // namespace
}  // namespace bulletnav::agent
