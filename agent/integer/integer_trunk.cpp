// SPDX-License-Identifier: MIT
#include "agent/integer/integer_trunk.h"

#include <utility>

#include "sim/base/check.h"
#include "sim/base/error.h"

namespace bulletnav::agent {
namespace {

constexpr int kStages = 4;
constexpr std::size_t kBlocksInStage = 2;
constexpr int kBorder = 1;  // of all pictures but the input: windows are 3 x 3 or 1 x 1
constexpr double kFineSteps = 1 << kFineBits;

PictureShape InputShape(const QuantisedTrunk& trunk) {
  if (trunk.rows < 16 || trunk.rows > 128 || trunk.rows % 16 != 0) {
    throw sim::Error("pictures of " + std::to_string(trunk.rows) + " rows");
  }
  const int cols = trunk.cols == 0 ? 4 * trunk.rows : trunk.cols;
  if (cols < 16 || cols > 512 || cols % 16 != 0) {
    throw sim::Error("pictures of " + std::to_string(cols) + " columns");
  }
  return {trunk.rows, cols, kInputChannels, kStemBorder};
}

std::vector<std::int32_t> FineOffsets(const PictureShape& shape, int count) {
  return PixelOffsets({shape.rows, shape.cols, shape.channels, 0}, count);
}

std::size_t FineSize(const PictureShape& shape) {
  return static_cast<std::size_t>(IntegerTrunk::kAtATime) * static_cast<std::size_t>(shape.rows) *
         static_cast<std::size_t>(shape.cols) * static_cast<std::size_t>(shape.channels);
}

PictureShape Halved(const PictureShape& shape) {
  return {shape.rows / 2, shape.cols / 2, shape.channels, kBorder};
}

QuantisedTrunk LayersOf(const QuantisedNet& net, const std::string& prefix, int halvings) {
  QuantisedTrunk trunk;
  trunk.in_scale = net.Scale(prefix + "input");
  trunk.stem = net.Layer(prefix + "stem");
  trunk.stem_scale = net.Scale(prefix + "stem");
  for (int i = 0; i < kStages * static_cast<int>(kBlocksInStage); ++i) {
    const int stage = i / 2;
    const std::string name =
        prefix + "stage" + std::to_string(stage + 1) + "_" + std::to_string(i % 2 + 1) + "_";
    QuantisedTrunk::Block block;
    block.first = net.Layer(name + "first");
    block.second = net.Layer(name + "second");
    block.stride = i % 2 == 0 && stage > 0 && stage <= halvings ? 2 : 1;
    block.first_scale = net.Scale(name + "first");
    block.second_scale = net.Scale(name + "second");
    if (net.layers.contains(name + "shortcut")) {
      block.shortcut = net.Layer(name + "shortcut");
      block.shortcut_scale = net.Scale(name + "shortcut");
    }
    trunk.blocks.push_back(std::move(block));
  }
  return trunk;
}

}  // namespace

QuantisedTrunk TrunkOf(const QuantisedNet& net, const std::string& prefix, int rows) {
  QuantisedTrunk trunk = LayersOf(net, prefix, rows == 128 ? 3 : rows == 64 ? 2 : 1);
  trunk.rows = rows;
  return trunk;
}

QuantisedTrunk FlatTrunkOf(const QuantisedNet& net, const std::string& prefix, int rows, int cols,
                           int halvings) {
  QuantisedTrunk trunk = LayersOf(net, prefix, halvings);
  trunk.rows = rows;
  trunk.cols = cols;
  trunk.ends_meet = false;
  return trunk;
}

std::size_t IntegerTrunk::IndexOf(int stage) {
  return kBlocksInStage * static_cast<std::size_t>(stage + 1);
}

IntegerTrunk::Step IntegerTrunk::MakeStep(const QuantisedLayer& layer, const Pictures& in,
                                          int stride, const LayerScales& scales) {
  const int kernel = layer.segments;
  if (layer.inputs != kernel * in.shape.channels || kernel / 2 > in.shape.border ||
      kernel % 2 != 1 || layer.outputs % kOutputBlock != 0 || in.shape.rows % stride != 0) {
    throw sim::Error("a convolution does not fit the pictures that it is given");
  }
  Step step = {DotLayer(layer, LayerWidth::k8, scales),
               PixelOffsets(in.shape, in.count, stride, kernel / 2), 0, in.shape.row_stride()};
  step.pixels = step.in_offsets.size() / static_cast<std::size_t>(in.count);
  return step;
}

IntegerTrunk::End IntegerTrunk::MakeEnd(const PictureShape& in, int stride, int channels,
                                        double scale) {
  const PictureShape shape = {in.rows / stride, in.cols / stride, channels, kBorder};
  return {Pictures(shape, kAtATime), std::vector<std::int16_t>(FineSize(shape)), scale,
          PixelOffsets(shape, kAtATime), FineOffsets(shape, kAtATime)};
}

IntegerTrunk::IntegerTrunk(const QuantisedTrunk& trunk)
    : ends_meet_(trunk.ends_meet),
      input_(InputShape(trunk), kAtATime, kInputZero),
      stem_(MakeStep(trunk.stem, input_, 2,
                     {trunk.in_scale, kInputZero, 255, trunk.stem_scale / kFineSteps})),
      stem_end_(MakeEnd(input_.shape, 2, trunk.stem.outputs, trunk.stem_scale)) {
  stem_end_.fine.clear();  // only blocks' ends are wanted so
  if (trunk.blocks.size() != kStages * kBlocksInStage) throw sim::Error("a trunk has eight blocks");
  ends_.reserve(1 + trunk.blocks.size());
  ends_.push_back(MakeEnd(Halved(stem_end_.out.shape), 1, trunk.stem.outputs, trunk.stem_scale));
  blocks_.reserve(trunk.blocks.size());
  for (const QuantisedTrunk::Block& block : trunk.blocks) AddBlock(block);
}

void IntegerTrunk::AddBlock(const QuantisedTrunk::Block& block) {
  const End& in = ends_.back();
  if (block.stride != 1 && block.stride != 2) throw sim::Error("strides are 1 or 2");
  const auto scales = [](double from, double to) {
    return LayerScales{from, 0, 255, to};
  };
  End middle = MakeEnd(in.out.shape, block.stride, block.first.outputs, double{block.first_scale});
  middle.fine.clear();
  End end = MakeEnd(middle.out.shape, 1, block.second.outputs, double{block.second_scale});
  Block made = {
      MakeStep(block.first, in.out, block.stride, scales(in.scale, middle.scale / kFineSteps)),
      middle,
      MakeStep(block.second, middle.out, 1,
               {middle.scale, 0, 255, end.scale / kFineSteps,
                block.shortcut ? block.shortcut_scale : in.scale / kFineSteps}),
      std::nullopt,
      {}};
  if (block.shortcut) {
    made.shortcut =
        MakeStep(*block.shortcut, in.out, block.stride, scales(in.scale, block.shortcut_scale));
    made.shortcut_fine.resize(end.fine.size());
  }
  const int kept = block.shortcut ? block.shortcut->outputs : in.out.shape.channels;
  if (kept != block.second.outputs || (!block.shortcut && block.stride != 1)) {
    throw sim::Error("a block's result and what is added to it differ in size");
  }
  blocks_.push_back(std::move(made));
  ends_.push_back(std::move(end));
}

void IntegerTrunk::RunStep(Step* step, const Pictures& in, int count, const KeptValues& kept,
                           End* end) const {
  LayerOutput output;
  output.bytes = end->out.bytes.data();
  output.byte_offsets = end->byte_offsets.data();
  if (!end->fine.empty()) {
    output.fine = end->fine.data();
    output.fine_offsets = end->fine_offsets.data();
  }
  const std::size_t pixels = step->pixels * static_cast<std::size_t>(count);
  step->layer.Run(
      {in.bytes.data(), std::span(step->in_offsets).first(pixels), step->segment_stride}, kept,
      output);
  if (ends_meet_) end->out.JoinEnds(count);
}

void IntegerTrunk::RunBlock(std::size_t index, int count) {
  Block& block = blocks_[index];
  const End& in = ends_[index];
  End& end = ends_[index + 1];
  RunStep(&block.first, in.out, count, {}, &block.middle);
  KeptValues kept;
  kept.values = in.fine.data();
  kept.offsets = end.fine_offsets.data();
  if (block.shortcut) {
    LayerOutput output;
    output.fine = block.shortcut_fine.data();
    output.fine_offsets = end.fine_offsets.data();
    output.low = -output.high;
    const std::size_t pixels = block.shortcut->pixels * static_cast<std::size_t>(count);
    block.shortcut->layer.Run(
        {in.out.bytes.data(), std::span(block.shortcut->in_offsets).first(pixels), 0}, {}, output);
    kept.values = block.shortcut_fine.data();
  }
  RunStep(&block.second, block.middle.out, count, kept, &end);
}

void IntegerTrunk::Run(int count) {
  BULLETNAV_CHECK(count >= 1 && count <= kAtATime);
  if (ends_meet_) input_.JoinEnds(count);
  RunStep(&stem_, input_, count, {}, &stem_end_);
  PoolLargest(stem_end_.out, count, &ends_[0].out, &ends_[0].fine);
  if (ends_meet_) ends_[0].out.JoinEnds(count);
  for (std::size_t i = 0; i < blocks_.size(); ++i) RunBlock(i, count);
}

void IntegerTrunk::Use(const IntegerKernels& kernels) {
  stem_.layer.Use(kernels);
  for (Block& block : blocks_) {
    block.first.layer.Use(kernels);
    block.second.layer.Use(kernels);
    if (block.shortcut) block.shortcut->layer.Use(kernels);
  }
}

}  // namespace bulletnav::agent
