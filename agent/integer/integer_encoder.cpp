// SPDX-License-Identifier: MIT
#include "agent/integer/integer_encoder.h"

#include <algorithm>

#include "sim/base/check.h"
#include "sim/base/error.h"

namespace bulletnav::agent {
namespace {

constexpr int kMapRows = 4;
constexpr int kMapCols = 16;
constexpr int kLastStage = 3;

std::array<std::array<int, kMapCols>, kDirections> MakeShares() {
  // In sixths of a column everything is whole: a column is six wide, a patch 24.
  std::array<std::array<int, kMapCols>, kDirections> shares{};
  for (int i = 0; i < kDirections; ++i) {
    const int middle = 6 * kMapCols / 2 - 6 * kMapCols / kDirections * i;
    for (int j = -kMapCols; j < 2 * kMapCols; ++j) {
      const int low = std::max(6 * j - 3, middle - 12);
      const int high = std::min(6 * j + 3, middle + 12);
      shares[static_cast<std::size_t>(i)][static_cast<std::size_t>((j + kMapCols) % kMapCols)] +=
          std::max(0, high - low);
    }
  }
  return shares;
}

LayerOutput FineOutput(std::vector<std::int16_t>* values, const std::int32_t* offsets) {
  LayerOutput output;
  output.fine = values->data();
  output.fine_offsets = offsets;
  output.high = kLargest16;
  return output;
}

}  // namespace

const std::array<std::array<int, 16>, kDirections>& PoolingShares24() {
  static const auto shares = MakeShares();
  return shares;
}

IntegerEncoder::IntegerEncoder(const QuantisedNet& net, int rows, bool uses_depth)
    : input_(rows, uses_depth),
      trunk_(TrunkOf(net, "encoder.trunk.", rows)),
      first_(net.Layer("encoder.first"), LayerWidth::k16,
             {trunk_.stage_scale(kLastStage) * kPooledStep, 0, kLargestPooled,
              net.Scale("encoder.first")}),
      second_(net.Layer("encoder.second"), LayerWidth::k16,
              {net.Scale("encoder.first"), 0, kLargest16, net.Scale("encoder.second")}) {
  const PictureShape& map = trunk_.bytes(kLastStage).shape;
  if (map.rows != kMapRows || map.cols != kMapCols ||
      net.Layer("encoder.first").inputs != map.channels ||
      net.Layer("encoder.second").inputs != first_.padded_outputs()) {
    throw sim::Error("the encoder's layers do not fit its trunk");
  }
}

void IntegerEncoder::Pool(int picture, std::int16_t* features) const {
  const Pictures& map = trunk_.bytes(kLastStage);
  const auto channels = static_cast<std::size_t>(map.shape.channels);
  std::vector<std::int16_t> columns(kMapCols * channels, 0);
  for (int row = 0; row < kMapRows; ++row) {
    const std::uint8_t* in =
        map.bytes.data() + std::ptrdiff_t{picture} * map.shape.size() + map.shape.Offset(row, 0);
    for (std::size_t i = 0; i < columns.size(); ++i) {
      columns[i] = static_cast<std::int16_t>(columns[i] + in[i]);
    }
  }
  std::fill_n(features, kDirections * channels, std::int16_t{0});
  for (std::size_t patch = 0; patch < kDirections; ++patch) {
    for (std::size_t column = 0; column < kMapCols; ++column) {
      const int share = PoolingShares24()[patch][column];
      if (share == 0) continue;
      std::int16_t* out = features + patch * channels;
      const std::int16_t* in = columns.data() + column * channels;
      for (std::size_t i = 0; i < channels; ++i) {
        out[i] = static_cast<std::int16_t>(out[i] + share * in[i]);
      }
    }
  }
}

IntegerEncoder::Codes IntegerEncoder::Encode(std::span<const Panorama> panoramas) {
  return EncodeAll(panoramas.size(), [&](std::size_t i, int slot) {
    input_.Prepare(panoramas[i], slot, trunk_.input());
  });
}

IntegerEncoder::Codes IntegerEncoder::EncodePictures(std::span<const std::uint8_t> pictures) {
  const PictureShape& shape = trunk_.input()->shape;
  BULLETNAV_CHECK_EQ(shape.channels, kInputChannels);
  const std::size_t row = static_cast<std::size_t>(shape.cols) * kInputChannels;
  const std::size_t picture = row * static_cast<std::size_t>(shape.rows);
  BULLETNAV_CHECK_EQ(pictures.size() % picture, std::size_t{0});
  return EncodeAll(pictures.size() / picture, [&](std::size_t i, int slot) {
    for (int r = 0; r < shape.rows; ++r) {
      const auto from = pictures.subspan(i * picture + static_cast<std::size_t>(r) * row, row);
      std::copy(
          from.begin(), from.end(),
          trunk_.input()->bytes.begin() + std::ptrdiff_t{slot} * shape.size() + shape.Offset(r, 0));
    }
  });
}

IntegerEncoder::Codes IntegerEncoder::EncodeAll(std::size_t count,
                                                const std::function<void(std::size_t, int)>& fill) {
  const std::size_t channels = static_cast<std::size_t>(trunk_.bytes(kLastStage).shape.channels);
  std::vector<std::int16_t> features(count * kDirections * channels);
  for (std::size_t done = 0; done < count; done += IntegerTrunk::kAtATime) {
    const auto some = static_cast<int>(std::min<std::size_t>(IntegerTrunk::kAtATime, count - done));
    for (int i = 0; i < some; ++i) fill(done + static_cast<std::size_t>(i), i);
    trunk_.Run(some);
    for (int i = 0; i < some; ++i) {
      Pool(i, features.data() + (done + static_cast<std::size_t>(i)) * kDirections * channels);
    }
  }
  const int pixels = static_cast<int>(count) * kDirections;
  const auto bytes = [&](int values) {
    return PixelOffsets({1, pixels, 2 * values, 0}, 1);
  };
  const auto numbers = [&](int values) {
    return PixelOffsets({1, pixels, values, 0}, 1);
  };
  const int hidden_size = first_.padded_outputs();
  std::vector<std::int16_t> hidden(static_cast<std::size_t>(pixels * hidden_size));
  Codes codes(static_cast<std::size_t>(pixels * code_size()));
  first_.Run({features.data(), bytes(static_cast<int>(channels)), 0}, {},
             FineOutput(&hidden, numbers(hidden_size).data()));
  second_.Run({hidden.data(), bytes(hidden_size), 0}, {},
              FineOutput(&codes, numbers(code_size()).data()));
  return codes;
}

void IntegerEncoder::Use(const IntegerKernels& kernels) {
  trunk_.Use(kernels);
  first_.Use(kernels);
  second_.Use(kernels);
}

}  // namespace bulletnav::agent
