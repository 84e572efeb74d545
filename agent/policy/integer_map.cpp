// SPDX-License-Identifier: MIT
#include "agent/policy/integer_map.h"

#include <array>
#include <utility>

#include "agent/policy/policy_map.h"
#include "sim/base/check.h"
#include "sim/base/error.h"

namespace bulletnav::agent {
namespace {

constexpr int kChannelsIn = 4;  // the planes, and an empty one that fills a word
constexpr int kBorder = 1;
constexpr int kWindow = 3;
constexpr int kStride = 2;
constexpr int kWordBytes = 2;  // of a value

std::size_t SizeOf(const PictureShape& shape) {
  return std::size_t{kMapCrops} * static_cast<std::size_t>(shape.size());
}

DotLayer WholeLayer(const QuantisedNet& net, int largest) {
  return {net.Layer("map.whole"),
          LayerWidth::k16,
          {net.Scale("map.third"), 0, largest, net.Scale("map.whole")}};
}

PictureShape ShapeAfter(const QuantisedNet& net, const std::string& name, const PictureShape& in,
                        int border) {
  return {in.rows / kStride, in.cols / kStride, net.Layer(name).outputs, border};
}

}  // namespace

IntegerMap::IntegerMap(const QuantisedNet& net, int largest)
    : largest_(largest),
      shape_{kMapSide, kMapSide, kChannelsIn, kBorder},
      whole_(WholeLayer(net, largest)),
      features_(static_cast<std::size_t>(whole_.padded_outputs())) {
  AddStage(net, "map.first", ShapeAfter(net, "map.first", shape_, kBorder));
  AddStage(net, "map.second", ShapeAfter(net, "map.second", shape_, kBorder));
  AddStage(net, "map.third", ShapeAfter(net, "map.third", shape_, 0));
  ends_.resize(SizeOf(shape_));
  const QuantisedLayer& last = net.Layer("map.whole");
  if (last.segments != 1 || static_cast<std::size_t>(last.inputs) != ends_.size()) {
    throw sim::Error("layer map.whole does not fit the map");
  }
}

void IntegerMap::AddStage(const QuantisedNet& net, const std::string& name,
                          const PictureShape& out) {
  const QuantisedLayer& layer = net.Layer(name);
  if (layer.segments != kWindow || layer.inputs != kWindow * shape_.channels ||
      layer.outputs % kOutputBlock != 0) {
    throw sim::Error("layer " + name + " does not fit the map");
  }
  const double to = net.Scale(name);
  const bool is_first = stages_.empty();
  Stage stage = {shape_, std::vector<std::int16_t>(SizeOf(shape_)),
                 DotLayer(layer, LayerWidth::k16, {step_, 0, is_first ? 1 : largest_, to}),
                 PixelOffsets(shape_, kMapCrops, kStride, kWindow / 2),
                 PixelOffsets(out, kMapCrops)};
  for (std::int32_t& offset : stage.in_offsets) offset *= kWordBytes;
  stages_.push_back(std::move(stage));
  shape_ = out;
  step_ = to;
}

void IntegerMap::SetPlanes(std::span<const std::uint8_t> bytes) {
  constexpr std::size_t kBits = 8;
  Stage& in = stages_.front();
  std::size_t bit = 0;
  const auto set_row = [&](int start) {
    std::int16_t* to = in.values.data() + start;
    for (int col = 0; col < kMapSide; ++col, ++bit, to += kChannelsIn) {
      *to = static_cast<std::int16_t>(bytes[bit / kBits] >> bit % kBits & 1);
    }
  };
  for (int crop = 0; crop < kMapCrops; ++crop) {
    for (int plane = 0; plane < kMapPlanes; ++plane) {
      const int first = crop * in.shape.size() + plane;
      for (int row = 0; row < kMapSide; ++row) set_row(first + in.shape.Offset(row, 0));
    }
  }
}

std::span<const std::int16_t> IntegerMap::Run(std::span<const std::uint8_t> bytes) {
  BULLETNAV_CHECK_EQ(bytes.size(), kPolicyMapBytes);
  SetPlanes(bytes);
  for (std::size_t i = 0; i < stages_.size(); ++i) {
    Stage& stage = stages_[i];
    LayerOutput output;
    output.fine = i + 1 < stages_.size() ? stages_[i + 1].values.data() : ends_.data();
    output.fine_offsets = stage.out_offsets.data();
    output.high = largest_;
    stage.layer.Run({stage.values.data(), stage.in_offsets, kWordBytes * stage.shape.row_stride()},
                    {}, output);
  }
  constexpr std::array<std::int32_t, 1> kStart = {0};
  LayerOutput output;
  output.fine = features_.data();
  output.fine_offsets = kStart.data();
  output.high = largest_;
  whole_.Run({ends_.data(), kStart, 0}, {}, output);
  return features_;
}

void IntegerMap::Use(const IntegerKernels& kernels) {
  for (Stage& stage : stages_) stage.layer.Use(kernels);
  whole_.Use(kernels);
}

}  // namespace bulletnav::agent
