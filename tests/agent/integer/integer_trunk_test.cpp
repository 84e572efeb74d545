// SPDX-License-Identifier: MIT
#include "agent/integer/integer_trunk.h"

#include "random_trunk.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "sim/base/error.h"

namespace bulletnav::agent {
namespace {

/// [rows, cols, channels], whose columns go round, if they do, and whose rows end in `outside`.
struct Plain {
  int rows;
  int cols;
  int channels;
  int outside = 0;
  std::vector<int> values = std::vector<int>(static_cast<std::size_t>(rows * cols * channels));
  bool ends_meet = true;

  int& At(int row, int col, int channel) {
    return values[static_cast<std::size_t>((row * cols + col) * channels + channel)];
  }
  int Around(int row, int col, int channel) {
    if (row < 0 || row >= rows) return outside;
    if (!ends_meet && (col < 0 || col >= cols)) return outside;
    return At(row, (col + cols) % cols, channel);
  }
};

struct Result {
  Plain fine;
  Plain bytes;
};

/// A convolution, what is kept and ReLU, one number after the other.
Result Convolve(const QuantisedLayer& layer, Plain in, int stride, const LayerScales& scales,
                const Plain* kept = nullptr, int low = 0) {
  const int kernel = layer.segments;
  double largest = scales.kept;
  for (const float scale : layer.scale) largest = std::max(largest, scales.in * scale);
  const int shift = std::min(32, 30 - std::ilogb(largest / scales.out));
  Plain fine = {in.rows / stride, in.cols / stride, layer.outputs};
  fine.ends_meet = in.ends_meet;
  Plain bytes = fine;
  for (int row = 0; row < fine.rows; ++row) {
    for (int col = 0; col < fine.cols; ++col) {
      for (int out = 0; out < layer.outputs; ++out) {
        std::int64_t sum = 0;
        std::size_t weight = static_cast<std::size_t>(out * kernel * layer.inputs);
        for (int y = 0; y < kernel; ++y) {
          for (int x = 0; x < kernel; ++x) {
            for (int channel = 0; channel < in.channels; ++channel, ++weight) {
              const int value =
                  in.Around(row * stride + y - kernel / 2, col * stride + x - kernel / 2, channel);
              sum += (value - scales.zero) * layer.weights[weight];
            }
          }
        }
        const auto o = static_cast<std::size_t>(out);
        const double step = scales.in * layer.scale[o];
        sum += std::llrint(layer.bias[o] / step);
        std::int64_t value = sum * std::llrint(std::ldexp(step / scales.out, shift));
        if (kept != nullptr) {
          value += kept->values[static_cast<std::size_t>((row * fine.cols + col) * fine.channels +
                                                         out)] *
                   std::llrint(std::ldexp(scales.kept / scales.out, shift));
        }
        value = (value + (std::int64_t{1} << (shift - 1))) >> shift;
        fine.At(row, col, out) = static_cast<int>(std::clamp<std::int64_t>(value, low, 32767));
        bytes.At(row, col, out) = std::min((fine.At(row, col, out) + 64) >> kFineBits, 255);
      }
    }
  }
  return {fine, bytes};
}

Plain Pool(Plain in) {
  Plain out = {in.rows / 2, in.cols / 2, in.channels};
  out.ends_meet = in.ends_meet;
  for (int row = 0; row < out.rows; ++row) {
    for (int col = 0; col < out.cols; ++col) {
      for (int i = 0; i < 9 * in.channels; ++i) {
        int& most = out.At(row, col, i / 9);
        most = std::max(most, in.Around(2 * row + i % 9 / 3 - 1, 2 * col + i % 3 - 1, i / 9));
      }
    }
  }
  return out;
}

/// The last stage's fine values.
Plain RunPlainly(const QuantisedTrunk& trunk, Plain input) {
  input.outside = kInputZero;
  input.ends_meet = trunk.ends_meet;
  Plain bytes = Pool(
      Convolve(trunk.stem, input, 2, {trunk.in_scale, kInputZero, 255, trunk.stem_scale / 128.0})
          .bytes);
  Plain fine = bytes;
  for (int& value : fine.values) value *= 128;
  double scale = trunk.stem_scale;
  for (const QuantisedTrunk::Block& block : trunk.blocks) {
    const Plain middle =
        Convolve(block.first, bytes, block.stride, {scale, 0, 255, block.first_scale / 128.0})
            .bytes;
    Plain kept = fine;
    double kept_scale = scale / 128.0;
    if (block.shortcut) {
      kept = Convolve(*block.shortcut, bytes, block.stride, {scale, 0, 255, block.shortcut_scale},
                      nullptr, -32767)
                 .fine;
      kept_scale = block.shortcut_scale;
    }
    const Result end =
        Convolve(block.second, middle, 1,
                 {block.first_scale, 0, 255, block.second_scale / 128.0, kept_scale}, &kept);
    bytes = end.bytes;
    fine = end.fine;
    scale = block.second_scale;
  }
  return fine;
}

Plain RandomPicture(int rows, std::uint64_t seed, int cols = 0) {
  sim::Rng rng(seed, "picture");
  Plain picture = {rows, cols == 0 ? 4 * rows : cols, kInputChannels};
  for (int& value : picture.values) value = rng.Between(0, 254);
  return picture;
}

void SetInput(const Plain& picture, int index, Pictures* pictures) {
  for (int row = 0; row < picture.rows; ++row) {
    std::copy_n(
        picture.values.begin() + row * picture.cols * picture.channels,
        picture.cols * picture.channels,
        pictures->bytes.begin() + index * pictures->shape.size() + pictures->shape.Offset(row, 0));
  }
}

std::vector<std::int16_t> EndOf(const IntegerTrunk& trunk, std::size_t index, std::size_t size) {
  const auto begin = trunk.fine(3).begin() + static_cast<std::ptrdiff_t>(index * size);
  return {begin, begin + static_cast<std::ptrdiff_t>(size)};
}

class EveryTrunk : public testing::TestWithParam<const IntegerKernels*> {};

TEST_P(EveryTrunk, IsWhatPlainLoopsMakeOfIt) {
  for (const int halvings : {1, 2, 3}) {
    const int rows = 16 << halvings;
    const QuantisedTrunk shape = RandomTrunk(rows / 2, 16, halvings, 1);
    const Plain picture = RandomPicture(rows / 2, 2);
    const Plain expected = RunPlainly(shape, picture);
    EXPECT_GT(std::count_if(expected.values.begin(), expected.values.end(),
                            [](int value) {
                              return value > 0 && value < 32767;
                            }),
              static_cast<std::ptrdiff_t>(expected.values.size() / 16));
    IntegerTrunk trunk(shape);
    trunk.Use(*GetParam());
    SetInput(picture, 0, trunk.input());
    trunk.Run(1);
    const auto values = EndOf(trunk, 0, expected.values.size());
    EXPECT_TRUE(std::equal(values.begin(), values.end(), expected.values.begin()));
  }
}

TEST_P(EveryTrunk, FlatPicturesHaveNothingBeyondTheirEnds) {
  QuantisedTrunk shape = RandomTrunk(48, 16, 2, 1);
  shape.cols = 64;
  shape.ends_meet = false;
  const Plain picture = RandomPicture(48, 2, 64);
  const Plain expected = RunPlainly(shape, picture);
  IntegerTrunk trunk(shape);
  trunk.Use(*GetParam());
  SetInput(RandomPicture(48, 3, 64), 0, trunk.input());
  trunk.Run(1);  // leaves nothing behind
  SetInput(picture, 0, trunk.input());
  trunk.Run(1);
  const auto values = EndOf(trunk, 0, expected.values.size());
  EXPECT_TRUE(std::equal(values.begin(), values.end(), expected.values.begin()));
}

TEST_P(EveryTrunk, SeveralPicturesAreAsOneByOne) {
  const QuantisedTrunk shape = RandomTrunk(32, 16, 1, 3);
  IntegerTrunk together(shape);
  IntegerTrunk alone(shape);
  together.Use(*GetParam());
  alone.Use(*SupportedIntegerKernels().back());
  for (int i = 0; i < IntegerTrunk::kAtATime; ++i) {
    SetInput(RandomPicture(32, static_cast<std::uint64_t>(i)), i, together.input());
  }
  together.Run(IntegerTrunk::kAtATime);
  const std::size_t size = together.fine(3).size() / IntegerTrunk::kAtATime;
  for (std::size_t i = 0; i < IntegerTrunk::kAtATime; ++i) {
    SetInput(RandomPicture(32, i), 0, alone.input());
    alone.Run(1);
    EXPECT_EQ(EndOf(alone, 0, size), EndOf(together, i, size));
  }
}

INSTANTIATE_TEST_SUITE_P(Supported, EveryTrunk,
                         testing::ValuesIn(SupportedIntegerKernels().begin(),
                                           SupportedIntegerKernels().end()));

TEST(IntegerTrunk, RefusesLayersThatDoNotFit) {
  const QuantisedTrunk good = RandomTrunk(32, 16, 1, 4);
  EXPECT_NO_THROW(IntegerTrunk{good});
  QuantisedTrunk bad = good;
  bad.blocks.pop_back();
  EXPECT_THROW(IntegerTrunk{bad}, sim::Error);
  bad = good;
  bad.blocks[2].shortcut.reset();
  EXPECT_THROW(IntegerTrunk{bad}, sim::Error);
  bad = good;
  bad.blocks[1].first.weights.pop_back();
  EXPECT_THROW(IntegerTrunk{bad}, sim::Error);
  bad = good;
  bad.blocks[1].first.weights[3] = 65;
  EXPECT_THROW(IntegerTrunk{bad}, sim::Error);
  bad = good;
  bad.stem_scale = 0.0f;
  EXPECT_THROW(IntegerTrunk{bad}, sim::Error);
  bad = good;
  bad.stem.scale[0] = -1.0f;
  EXPECT_THROW(IntegerTrunk{bad}, sim::Error);
  bad = good;
  bad.stem.bias[0] = 1e30f;
  EXPECT_THROW(IntegerTrunk{bad}, sim::Error);
  bad = good;
  bad.rows = 1 << 30;
  EXPECT_THROW(IntegerTrunk{bad}, sim::Error);
}

}  // namespace
}  // namespace bulletnav::agent
