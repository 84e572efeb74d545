// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>

/// The inner loops of networks in integers, compiled once for each instruction set and chosen when
/// the program starts. Plain structs of pointers: these files must not pull in code from std that
/// the linker could then use elsewhere on a processor without that instruction set.
/// All variants compute the same bits: sums are exact, and rounding is of one kind.
namespace bulletnav::agent {

/// Outputs come in blocks of so many: weights, factors and sums are padded to whole blocks.
inline constexpr int kOutputBlock = 16;
/// Eight-bit weights lie within +-this, so that a sum of two products of 255 fits into 16 bits.
inline constexpr int kLargestWeight8 = 64;
/// Fine values count 128 to a step of the eight-bit ones.
inline constexpr int kFineBits = 7;

/// Scalar products of weights with inputs around each of some pixels. The inputs of a pixel are
/// `segments` stretches of memory (rows of a convolution's window), `steps` words of 32 bits each:
/// four unsigned bytes, or two signed 16-bit numbers. A word of weights is four signed bytes within
/// kLargestWeight8, or two 16-bit numbers other than -32768.
struct DotJob {
  const std::uint8_t* in;
  const std::int32_t* offsets;  // [pixels] bytes from `in` to a pixel's first word
  std::int32_t pixels;
  std::int32_t segments;
  std::int32_t segment_stride;  // bytes
  std::int32_t steps;
  const std::int32_t* weights;  // [blocks, segments, steps, kOutputBlock]
  std::int32_t blocks;
  std::int32_t* sums;  // [pixels, blocks * kOutputBlock]; exact if they fit into 32 bits
};

/// fine = ((sum + bias) * factor + (kept + kept2) * kept_factor) / 2^shift, to the nearest
/// and halves up, clamped to [low, high]; eight-bit value: fine / 2^kFineBits, likewise, clamped
/// to [0, 255]. Fine values must fit into 32 bits before they are clamped.
struct ScaleJob {
  const std::int32_t* sums;  // [pixels, outputs]
  std::int32_t pixels;
  std::int32_t outputs;               // a multiple of kOutputBlock
  const std::int32_t* bias;           // [outputs]
  const std::int32_t* factor;         // [outputs]
  const std::int16_t* kept;           // null: none
  const std::int32_t* kept_offsets;   // [pixels] numbers from `kept` to a pixel's first
  const std::int16_t* kept2;          // null: none; only beside `kept`
  const std::int32_t* kept2_offsets;  // likewise
  std::int32_t kept_factor;
  std::int32_t shift;  // 1 to 32
  std::int32_t low;    // within 16 bits
  std::int32_t high;
  std::uint8_t* out8;                // null: not wanted
  const std::int32_t* out8_offsets;  // [pixels]
  std::int16_t* out16;               // null: not wanted
  const std::int32_t* out16_offsets;
};

struct IntegerKernels {
  const char* name;
  void (*dot8)(const DotJob&);
  void (*dot16)(const DotJob&);
  void (*scale)(const ScaleJob&);
};

/// The kernels this processor can run and BULLETNAV_ISA allows, the fastest first; at least one.
std::span<const IntegerKernels* const> SupportedIntegerKernels();

extern const IntegerKernels kIntegerKernelsGeneric;
#ifdef __x86_64__
extern const IntegerKernels kIntegerKernelsSse41;
extern const IntegerKernels kIntegerKernelsAvx2;
extern const IntegerKernels kIntegerKernelsAvx512;
extern const IntegerKernels kIntegerKernelsVnni;
extern const IntegerKernels kIntegerKernelsAmx;
#endif

}  // namespace bulletnav::agent
