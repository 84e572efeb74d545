// SPDX-License-Identifier: MIT
#include "agent/slam/descriptors/picture_describer.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>

#include "agent/integer/quantised_file.h"
#include "agent/slam/descriptors/shrink_picture.h"
#include "sim/base/check.h"
#include "sim/base/error.h"

namespace bulletnav::agent {
namespace {

constexpr int kCellStage = 2;  // of four
constexpr int kLastStage = 3;

std::size_t Bytes(const DescriptorConfig& config) {
  return static_cast<std::size_t>(config.rows) * static_cast<std::size_t>(config.cols()) * 3;
}

}  // namespace

PictureDescriber::PictureDescriber(const QuantisedNet& net, const DescriptorConfig& config)
    : config_(config),
      trunk_(FlatTrunkOf(net, "trunk.", config.rows, config.cols(), kDescriptorHalvings)),
      gem_(double{net.Scale("exponent")}),
      out_(net.Layer("out"), LayerWidth::k16,
           {trunk_.stage_scale(kLastStage) / (1 << Gem::kBits), 0, Gem::kLargest,
            net.Scale("out")}) {
  if (net.Layer("out").inputs != trunk_.bytes(kLastStage).shape.channels ||
      net.Layer("out").outputs != config.size) {
    throw sim::Error("the descriptor's layers do not fit together");
  }
}

PictureDescriptor PictureDescriber::Describe(std::span<const std::uint8_t> rgb, int width_px,
                                             int height_px) {
  return DescribeShrunk(ShrinkPicture(rgb, width_px, height_px, config_.rows, config_.cols()));
}

PictureDescriptor PictureDescriber::DescribeShrunk(std::span<const std::uint8_t> picture) {
  BULLETNAV_CHECK_EQ(picture.size(), Bytes(config_));
  Pictures* input = trunk_.input();
  const std::uint8_t* from = picture.data();
  for (int row = 0; row < config_.rows; ++row) {
    std::uint8_t* to = input->bytes.data() + input->shape.Offset(row, 0);
    for (int col = 0; col < config_.cols(); ++col, from += 3, to += kInputChannels) {
      std::copy(from, from + 3, to);
    }
  }
  trunk_.Run(1);
  const Pictures& map = trunk_.bytes(kLastStage);
  std::vector<const std::uint8_t*> places;
  for (int row = 0; row < map.shape.rows; ++row) {
    for (int col = 0; col < map.shape.cols; ++col) {
      places.push_back(map.bytes.data() + map.shape.Offset(row, col));
    }
  }
  const std::vector<std::int16_t> pooled = gem_.Pool(places, map.shape.channels);
  std::vector<std::int16_t> values(static_cast<std::size_t>(out_.padded_outputs()));
  constexpr std::array<std::int32_t, 1> kFirst = {0};
  LayerOutput output;
  output.fine = values.data();
  output.fine_offsets = kFirst.data();
  output.low = -output.high;
  out_.Run({pooled.data(), kFirst, 0}, {}, output);
  values.resize(static_cast<std::size_t>(config_.size));
  const std::vector<std::int64_t> numbers(values.begin(), values.end());
  return DirectionOf(numbers);
}

std::vector<std::uint8_t> PictureDescriber::Cells() const {
  const Pictures& map = trunk_.bytes(kCellStage);
  std::vector<std::uint8_t> cells;
  for (int row = 0; row < map.shape.rows; ++row) {
    const auto first = map.bytes.begin() + map.shape.Offset(row, 0);
    cells.insert(cells.end(), first, first + std::ptrdiff_t{map.shape.cols} * map.shape.channels);
  }
  return cells;
}

void PictureDescriber::Use(const IntegerKernels& kernels) {
  trunk_.Use(kernels);
  out_.Use(kernels);
}

std::unique_ptr<PictureDescriber> LoadPictureDescriber(const std::filesystem::path& weights) {
  const TensorFile content = ReadTensorFile(weights);
  const DescriptorConfig config = DescriptorConfigOf(content, weights);
  const QuantisedNet net = ReadQuantised(content, weights);
  try {
    return std::make_unique<PictureDescriber>(net, config);
  } catch (const sim::Error& error) {
    throw sim::FileError(weights, kIntegerPrefix,
                         std::string("cannot be used: ") + error.what() + "; train it again");
  }
}

}  // namespace bulletnav::agent
