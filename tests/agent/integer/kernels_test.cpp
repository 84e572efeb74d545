// SPDX-License-Identifier: MIT
// Every kernel of every instruction set against plain loops, with random and with worst values.
#include "agent/integer/kernels/kernels.h"

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sim/math/rng.h"

namespace bulletnav::agent {
namespace {

struct DotShape {
  std::string name;
  int pixels;
  int segments;
  int steps;
  int blocks;
};

const std::vector<DotShape> kShapes = {
    {"OneOfAll", 1, 1, 1, 1},           {"ATileAndMore", 13, 3, 5, 1},
    {"TwoBlocks", 25, 3, 24, 2},        {"ThreeBlocks", 7, 2, 3, 3},
    {"SevenBlocks", 31, 1, 9, 7},       {"AsStem", 64, 7, 7, 2},
    {"AsTheLastStage", 16, 3, 192, 16}, {"WordsOfAPrime", 17, 1, 37, 5},
    {"TooLongForTiles", 3, 3, 217, 2},
};

enum class Values { kRandom, kLargest, kAlternating };

/// A job and the memory that it points to.
struct Dots {
  std::vector<std::uint8_t> in;
  std::vector<std::int32_t> offsets;
  std::vector<std::int32_t> weights;
  std::vector<std::int32_t> sums;
  DotJob job{};

  Dots(const DotShape& shape, std::uint64_t seed) {
    sim::Rng rng(seed, "dots");
    const int stride = 4 * shape.steps + 12;
    const int pixel = 20;  // windows overlap, and do not lie at multiples of a vector
    in.resize(static_cast<std::size_t>(stride * shape.segments + pixel * shape.pixels));
    for (int i = 0; i < shape.pixels; ++i) offsets.push_back(pixel * (shape.pixels - 1 - i));
    const auto words = static_cast<std::size_t>(shape.segments * shape.steps) * kOutputBlock;
    weights.resize(words * static_cast<std::size_t>(shape.blocks));
    sums.assign(static_cast<std::size_t>(shape.pixels * shape.blocks * kOutputBlock), -7);
    job = {in.data(),   offsets.data(), shape.pixels, shape.segments, stride,
           shape.steps, weights.data(), shape.blocks, sums.data()};
  }

  template <class T>
  static T Word(const void* from, std::int64_t index) {
    T value{};
    std::memcpy(&value, static_cast<const std::uint8_t*>(from) + index * std::int64_t{sizeof(T)},
                sizeof(T));
    return value;
  }

  template <class In, class Weight>
  std::vector<std::int32_t> Expected() const {
    constexpr int kPerWord = 4 / sizeof(In);
    std::vector<std::int32_t> expected;
    for (int pixel = 0; pixel < job.pixels; ++pixel) {
      for (int output = 0; output < job.blocks * kOutputBlock; ++output) {
        std::int64_t sum = 0;
        for (int k = 0; k < job.segments * job.steps; ++k) {
          const std::uint8_t* at = job.in + job.offsets[pixel] +
                                   k / job.steps * job.segment_stride + 4 * (k % job.steps);
          const std::int64_t word =
              (std::int64_t{output / kOutputBlock} * job.segments * job.steps + k) * kOutputBlock +
              output % kOutputBlock;
          for (int i = 0; i < kPerWord; ++i) {
            sum += std::int64_t{Word<In>(at, i)} * Word<Weight>(job.weights, word * kPerWord + i);
          }
        }
        EXPECT_EQ(sum, static_cast<std::int32_t>(sum)) << "the case itself is wrong";
        expected.push_back(static_cast<std::int32_t>(sum));
      }
    }
    return expected;
  }
};

void Fill8(Values values, sim::Rng* rng, Dots* dots) {
  std::vector<std::int8_t> weights(4 * dots->weights.size());
  for (std::size_t i = 0; i < dots->in.size(); ++i) {
    dots->in[i] = values == Values::kRandom ? static_cast<std::uint8_t>(rng->Between(0, 255))
                                            : std::uint8_t{255};
  }
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const bool is_odd = values == Values::kAlternating && i / 2 % 2 == 1;
    const int largest = is_odd ? -kLargestWeight8 : kLargestWeight8;
    weights[i] = static_cast<std::int8_t>(
        values == Values::kRandom ? rng->Between(-kLargestWeight8, kLargestWeight8) : largest);
  }
  std::memcpy(dots->weights.data(), weights.data(), weights.size());
}

void Fill16(Values values, int longest, sim::Rng* rng, Dots* dots) {
  // As large as sums of 32 bits let them be.
  const int largest = std::min(32767, static_cast<int>(2147483647.0 / longest / 32767.0));
  std::vector<std::int16_t> in(dots->in.size() / 2);
  std::vector<std::int16_t> weights(2 * dots->weights.size());
  for (auto& value : in) {
    value =
        static_cast<std::int16_t>(values == Values::kRandom ? rng->Between(-32767, 32767) : 32767);
  }
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const int extreme = values == Values::kAlternating ? -largest : largest;
    weights[i] = static_cast<std::int16_t>(
        values == Values::kRandom ? rng->Between(-largest, largest) : extreme);
  }
  std::memcpy(dots->in.data(), in.data(), 2 * in.size());
  std::memcpy(dots->weights.data(), weights.data(), 2 * weights.size());
}

class EveryKernel : public testing::TestWithParam<const IntegerKernels*> {};

TEST_P(EveryKernel, SumsBytesExactly) {
  for (const DotShape& shape : kShapes) {
    for (const Values values : {Values::kRandom, Values::kLargest, Values::kAlternating}) {
      Dots dots(shape, 1);
      sim::Rng rng(2, shape.name);
      Fill8(values, &rng, &dots);
      GetParam()->dot8(dots.job);
      EXPECT_EQ(dots.sums, (dots.Expected<std::uint8_t, std::int8_t>())) << shape.name;
    }
  }
}

TEST_P(EveryKernel, SumsSixteenBitsExactly) {
  for (const DotShape& shape : kShapes) {
    for (const Values values : {Values::kRandom, Values::kLargest, Values::kAlternating}) {
      Dots dots(shape, 3);
      sim::Rng rng(4, shape.name);
      Fill16(values, 2 * shape.segments * shape.steps, &rng, &dots);
      GetParam()->dot16(dots.job);
      EXPECT_EQ(dots.sums, (dots.Expected<std::int16_t, std::int16_t>())) << shape.name;
    }
  }
}

/// As DotTest, of ScaleJob.
struct Scaling {
  static constexpr int kPixels = 9;
  static constexpr int kShift = 24;
  static constexpr int kOutputs = 3 * kOutputBlock;
  static constexpr int kStride = kOutputs + 5;
  std::vector<std::int32_t> sums, bias, factor, offsets, offsets2;
  std::vector<std::int16_t> kept, kept2, out16;
  std::vector<std::uint8_t> out8;
  ScaleJob job{};

  Scaling(std::uint64_t seed, bool is_extreme) {
    sim::Rng rng(seed, "scaling");
    const auto draw = [&](std::int64_t largest) {
      if (is_extreme) return static_cast<std::int32_t>(rng.Between(0, 1) == 0 ? -largest : largest);
      return static_cast<std::int32_t>(rng.Uniform(-1.0, 1.0) * static_cast<double>(largest));
    };
    for (int i = 0; i < kPixels * kOutputs; ++i) sums.push_back(draw(1'000'000'000));
    for (int i = 0; i < kOutputs; ++i) {
      bias.push_back(draw(1'000'000'000));
      factor.push_back(std::abs(draw(i % 3 == 0 ? 8'000'000 : 1000)));
    }
    for (int i = 0; i < kPixels; ++i) {
      offsets.push_back(kStride * (kPixels - 1 - i));
      offsets2.push_back(kStride * (i / 2));
    }
    for (int i = 0; i < kPixels * kStride; ++i) {
      kept.push_back(static_cast<std::int16_t>(draw(32767)));
      kept2.push_back(static_cast<std::int16_t>(draw(32767)));
    }
    out16.assign(static_cast<std::size_t>(kPixels * kStride), 1234);
    out8.assign(static_cast<std::size_t>(kPixels * kStride), 77);
    job = {.sums = sums.data(),
           .pixels = kPixels,
           .outputs = kOutputs,
           .bias = bias.data(),
           .factor = factor.data(),
           .kept = kept.data(),
           .kept_offsets = offsets.data(),
           .kept2 = kept2.data(),
           .kept2_offsets = offsets2.data(),
           .kept_factor = 3 << (kShift - 1),
           .shift = kShift,
           .low = -32767,
           .high = 32767,
           .out8 = out8.data(),
           .out8_offsets = offsets.data(),
           .out16 = out16.data(),
           .out16_offsets = offsets.data()};
  }

  std::int64_t Fine(int pixel, int output) const {
    const std::int64_t sum = sums[static_cast<std::size_t>(pixel * kOutputs + output)];
    std::int64_t value = (sum + job.bias[output]) * job.factor[output];
    if (job.kept != nullptr) {
      std::int64_t more = job.kept[job.kept_offsets[pixel] + output];
      if (job.kept2 != nullptr) more += job.kept2[job.kept2_offsets[pixel] + output];
      value += more * job.kept_factor;
    }
    value = (value + (std::int64_t{1} << (job.shift - 1))) >> job.shift;
    return std::clamp<std::int64_t>(value, job.low, job.high);
  }

  void Check() const {
    for (int pixel = 0; pixel < kPixels; ++pixel) {
      for (int output = 0; output < kStride; ++output) {
        const auto at = static_cast<std::size_t>(offsets[static_cast<std::size_t>(pixel)] + output);
        const bool is_one = output < kOutputs;
        const std::int64_t fine = is_one ? Fine(pixel, output) : 0;
        const std::int64_t coarse = std::clamp<std::int64_t>((fine + 64) >> kFineBits, 0, 255);
        EXPECT_EQ(out16[at], is_one && job.out16 != nullptr ? fine : 1234);
        EXPECT_EQ(out8[at], is_one && job.out8 != nullptr ? coarse : 77);
      }
    }
  }
};

TEST_P(EveryKernel, RoundsHalvesUpAndClamps) {
  for (const bool is_extreme : {false, true}) {
    for (int parts = 0; parts < 24; ++parts) {
      Scaling scaling(5 + static_cast<std::uint64_t>(parts), is_extreme);
      if (parts % 3 < 2) scaling.job.kept2 = nullptr;
      if (parts % 3 < 1) scaling.job.kept = nullptr;
      if (parts / 3 % 2 == 0) scaling.job.out8 = nullptr;
      if (parts / 6 % 2 == 0) scaling.job.out16 = nullptr;
      if (parts / 12 % 2 == 0) scaling.job.low = 0;
      if (parts % 4 == 1) scaling.job.shift = 32;
      GetParam()->scale(scaling.job);
      scaling.Check();
    }
  }
}

TEST_P(EveryKernel, RoundsHalvesUp) {
  Scaling scaling(9, false);
  scaling.job.kept = scaling.job.kept2 = nullptr;
  std::fill(scaling.bias.begin(), scaling.bias.end(), 0);
  std::fill(scaling.factor.begin(), scaling.factor.end(), 1 << (Scaling::kShift - 1));
  for (std::size_t i = 0; i < scaling.sums.size(); ++i) scaling.sums[i] = static_cast<int>(i) - 40;
  GetParam()->scale(scaling.job);
  scaling.Check();
  EXPECT_EQ(scaling.out16[static_cast<std::size_t>(scaling.offsets[0])], -20);
  EXPECT_EQ(scaling.out16[static_cast<std::size_t>(scaling.offsets[0]) + 1], -19);  // of -19.5
}

INSTANTIATE_TEST_SUITE_P(Supported, EveryKernel,
                         testing::ValuesIn(SupportedIntegerKernels().begin(),
                                           SupportedIntegerKernels().end()),
                         [](const auto& test) {
                           std::string name = test.param->name;
                           std::erase_if(name, [](char c) {
                             return !std::isalnum(c);
                           });
                           return name;
                         });

}  // namespace
}  // namespace bulletnav::agent
