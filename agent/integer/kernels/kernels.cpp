// SPDX-License-Identifier: MIT
// Compiled once for each instruction set, with BULLETNAV_KERNELS naming the table to define and
// BULLETNAV_KERNELS_NAME what to call it; see CMakeLists.txt.
#include "agent/integer/kernels/kernels.h"

#include "agent/integer/kernels/lanes.h"
#ifdef __AMX_INT8__
#include "agent/integer/kernels/tiles.h"
#endif

namespace bulletnav::agent {
namespace {

struct Dot8 {
  static Lanes AddTo(Lanes sum, Lanes in, Lanes weights) { return AddDot8(sum, in, weights); }
};
struct Dot16 {
  static Lanes AddTo(Lanes sum, Lanes in, Lanes weights) { return AddDot16(sum, in, weights); }
};

inline Lanes SplatWord(const std::uint8_t* p) {
  std::int32_t word = 0;
  std::memcpy(&word, p, sizeof(word));
  return Splat(word);
}

/// The part of a job that stays in registers: kPixels pixels from `first` on (the last one again
/// where there are fewer), kVectors vectors of outputs from `weights` on, each `apart` words from
/// the one before in weights, kLanes in sums.
template <class Dot, int kPixels, int kVectors>
inline void DotTile(  // NOLINT(readability-function-size): one loop that stays in registers
    const DotJob& job, std::int32_t first, std::int32_t block) {
  constexpr int kInBlock = kOutputBlock / kLanes;  // vectors
  const std::int32_t words = job.segments * job.steps * kOutputBlock;
  const std::int32_t count =
      job.pixels - first < kPixels ? job.pixels - first : std::int32_t{kPixels};
  const std::uint8_t* in[kPixels];
  for (int p = 0; p < kPixels; ++p) {
    in[p] = job.in + job.offsets[first + (p < count ? p : count - 1)];
  }
  const std::int32_t* weights[kVectors];
  for (int v = 0; v < kVectors; ++v) {
    weights[v] = job.weights + std::int64_t{words} * (block + v / kInBlock) + v % kInBlock * kLanes;
  }
  Lanes sums[kPixels][kVectors];
  BULLETNAV_UNROLL_ALL
  for (int p = 0; p < kPixels; ++p) {
    BULLETNAV_UNROLL_ALL
    for (int v = 0; v < kVectors; ++v) sums[p][v] = Splat(0);
  }
  std::int64_t word = 0;
  for (std::int32_t segment = 0; segment < job.segments; ++segment) {
    std::int64_t at = std::int64_t{segment} * job.segment_stride;
    BULLETNAV_UNROLL_SOME
    for (std::int32_t step = 0; step < job.steps; ++step, at += 4, word += kOutputBlock) {
      Lanes w[kVectors];
      BULLETNAV_UNROLL_ALL
      for (int v = 0; v < kVectors; ++v) w[v] = Load(weights[v] + word);
      BULLETNAV_UNROLL_ALL
      for (int p = 0; p < kPixels; ++p) {
        const Lanes value = SplatWord(in[p] + at);
        BULLETNAV_UNROLL_ALL
        for (int v = 0; v < kVectors; ++v) sums[p][v] = Dot::AddTo(sums[p][v], value, w[v]);
      }
    }
  }
  const std::int64_t outputs = std::int64_t{job.blocks} * kOutputBlock;
  BULLETNAV_UNROLL_ALL
  for (int p = 0; p < kPixels; ++p) {
    if (p >= count) continue;  // not break: sums would be kept in memory to be counted
    std::int32_t* out = job.sums + (first + p) * outputs + block * kOutputBlock;
    BULLETNAV_UNROLL_ALL
    for (int v = 0; v < kVectors; ++v) Store(out + v * kLanes, sums[p][v]);
  }
}

template <class Dot, int kPixels, int kVectors>
inline void DotBlocks(const DotJob& job, std::int32_t block) {
  for (std::int32_t first = 0; first < job.pixels; first += kPixels) {
    DotTile<Dot, kPixels, kVectors>(job, first, block);
  }
}

template <class Dot>
void RunDot(const DotJob& job) {
  std::int32_t block = 0;
#if defined(__AVX512BW__)
  for (; block + 4 <= job.blocks; block += 4) DotBlocks<Dot, 6, 4>(job, block);
  for (; block + 2 <= job.blocks; block += 2) DotBlocks<Dot, 12, 2>(job, block);
  for (; block < job.blocks; ++block) DotBlocks<Dot, 12, 1>(job, block);
#elif defined(__AVX2__)
  for (; block < job.blocks; ++block) DotBlocks<Dot, 4, 2>(job, block);
#elif defined(__SSE4_1__)
  for (; block < job.blocks; ++block) DotBlocks<Dot, 2, 4>(job, block);
#else
  for (; block < job.blocks; ++block) DotBlocks<Dot, 1, kOutputBlock>(job, block);
#endif
}

void RunDot8(const DotJob& job) {
#ifdef __AMX_INT8__
  if (FitsTiles(job)) return RunDotTiles(job);
#endif
  RunDot<Dot8>(job);
}

/// kLanes outputs of all pixels, so that what belongs to the outputs stays in registers. kKept: how
/// many values are added to each.
template <int kKept>
inline void ScaleLanes(const ScaleJob& job, std::int32_t output) {
  const Lanes bias = Load(job.bias + output);
  const Lanes factor = Load(job.factor + output);
  const Lanes odd_factor = OddToEven(factor);
  const Lanes kept_factor = Splat(job.kept_factor);
  const Wide half = SplatWide(std::int64_t{1} << (job.shift - 1));
  const Lanes low = Splat(job.low);
  const Lanes high = Splat(job.high);
  const Lanes half8 = Splat(1 << (kFineBits - 1));
  const std::int32_t* sums = job.sums + output;
  for (std::int32_t pixel = 0; pixel < job.pixels; ++pixel, sums += job.outputs) {
    const Lanes value = Add(Load(sums), bias);
    Wide even = AddWide(Multiply(value, factor), half);
    Wide odd = AddWide(Multiply(OddToEven(value), odd_factor), half);
    if constexpr (kKept > 0) {
      Lanes more = Load16(job.kept + job.kept_offsets[pixel] + output);
      if constexpr (kKept > 1) {
        more = Add(more, Load16(job.kept2 + job.kept2_offsets[pixel] + output));
      }
      even = AddWide(even, Multiply(more, kept_factor));
      odd = AddWide(odd, Multiply(OddToEven(more), kept_factor));
    }
    const Lanes fine = Min(Max(Interleave(even, odd, job.shift), low), high);
    if (job.out16 != nullptr) Store16(job.out16 + job.out16_offsets[pixel] + output, fine);
    if (job.out8 == nullptr) continue;
    const Lanes coarse = ShiftRight<kFineBits>(Add(fine, half8));
    Store8(job.out8 + job.out8_offsets[pixel] + output, Min(Max(coarse, Splat(0)), Splat(255)));
  }
}

void Scale(const ScaleJob& job) {
  for (std::int32_t output = 0; output < job.outputs; output += kLanes) {
    if (job.kept2 != nullptr) {
      ScaleLanes<2>(job, output);
    } else if (job.kept != nullptr) {
      ScaleLanes<1>(job, output);
    } else {
      ScaleLanes<0>(job, output);
    }
  }
}

}  // namespace

const IntegerKernels BULLETNAV_KERNELS = {BULLETNAV_KERNELS_NAME, RunDot8, RunDot<Dot16>, Scale};

}  // namespace bulletnav::agent
