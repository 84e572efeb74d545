// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>

/// The inner loops of PictureNoise, compiled once for each instruction set and chosen when the
/// program starts. Plain structs of pointers, and nothing from std in what is compiled so: see
/// sim/render/kernels/kernels.h. All variants compute the same bits.
namespace bulletnav::sim {

/// A picture's colour; see ColorNoise.
struct ColorNoiseFrame {
  int rows;
  int cols;
  bool wraps;              // the first column follows the last
  const std::uint8_t* in;  // [rows, cols, 3]
  std::uint8_t* out;       // other memory
  std::uint16_t* line;     // [3 cols + 6]
  std::uint32_t blur;      // share of each neighbour in a row of three, in 1/256
  float exposure;          // factor of display values
  float shot;              // 1 / electrons
  float read_squared;      // variance of light
  float balance[3];        // factor of display values
  std::uint32_t key[2];
};

/// A picture's depth; see DepthNoise.
struct DepthNoiseFrame {
  int rows;
  int cols;
  int stride;                 // of `depth`
  int window;                 // of shadows: columns that can hide one to their left; a power of two
  const float* depth;         // [rows, stride], with a neighbour before and after each row
  const std::uint8_t* color;  // [rows, cols, 3] or null
  float* out;                 // [rows, cols]
  float* line;                // [4, cols + window + 1]
  const float* azimuth;       // [cols + window + 1] radians, rising
  const float* across;        // [cols] 1 / angle to the next column, in the middle row
  const float* upwards;       // [rows] 1 / angle to the next row
  const float* stretch;       // [rows] factor of `across`
  float axial;
  float axial_per_m2;
  float axial_from;
  float grazing;
  float disparity;  // 0: no steps
  float lateral;    // mean size of the error sideways, radians
  float baseline;
  float min_range;
  float max_range;  // nothing is read from here on
  float clip;       // readings end here
  float min_cos;
  float min_signal;
  std::uint32_t key[2];
};

struct NoiseKernels {
  const char* name;
  void (*color)(const ColorNoiseFrame& frame);
  void (*depth)(const DepthNoiseFrame& frame);
};

extern const NoiseKernels kNoiseKernelsGeneric;
extern const NoiseKernels kNoiseKernelsAvx2;
extern const NoiseKernels kNoiseKernelsAvx512;

/// Those that this processor can run, the fastest first.
std::span<const NoiseKernels* const> SupportedNoiseKernels();

}  // namespace bulletnav::sim
