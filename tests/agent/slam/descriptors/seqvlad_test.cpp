// SPDX-License-Identifier: MIT
#include "agent/slam/descriptors/seqvlad.h"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "agent/integer/quantised_file.h"
#include "sim/base/error.h"
#include "sim/math/rng.h"

namespace bulletnav::agent {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr int kClusters = 6;
constexpr int kChannels = 16;
constexpr int kSize = 24;
constexpr int kWhole = kClusters * kChannels;

TensorFile::Tensor RandomTensor(std::vector<std::int64_t> shape, double deviation, sim::Rng* rng) {
  TensorFile::Tensor tensor{std::move(shape), {}};
  std::int64_t count = 1;
  for (const std::int64_t size : tensor.shape) count *= size;
  for (std::int64_t i = 0; i < count; ++i) {
    tensor.values.push_back(static_cast<float>(deviation * rng->Normal()));
  }
  return tensor;
}

TensorFile SomeWeights() {
  sim::Rng rng(1, "seqvlad");
  TensorFile weights;
  weights.metadata[kSequenceKey] = "{clusters: 6, channels: 16, size: 24}";
  weights.tensors["assign"] = RandomTensor({kClusters, kChannels}, 6.0, &rng);
  weights.tensors["centres"] = RandomTensor({kClusters, kChannels}, 0.2, &rng);
  weights.tensors["mean"] = RandomTensor({kWhole}, 0.02, &rng);
  weights.tensors["projection"] = RandomTensor({kSize, kWhole}, 0.1, &rng);
  return weights;
}

std::vector<std::uint8_t> Cells(int cells, std::uint64_t seed) {
  sim::Rng rng(seed, "cells");
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(cells * kChannels));
  for (std::uint8_t& byte : bytes)
    byte = static_cast<std::uint8_t>(std::max(0, rng.Between(-100, 255)));
  return bytes;
}

void MakeUnit(std::vector<double>* numbers, std::size_t first, std::size_t count) {
  double squares = 0.0;
  for (std::size_t i = first; i < first + count; ++i) squares += (*numbers)[i] * (*numbers)[i];
  for (std::size_t i = first; i < first + count; ++i) {
    (*numbers)[i] /= std::max(1e-12, std::sqrt(squares));
  }
}

/// The formula in floating point, one cell after the other.
std::vector<double> DescribedPlainly(const TensorFile& weights,
                                     const std::vector<std::uint8_t>& bytes) {
  const auto& assign = weights.tensors.at("assign").values;
  const auto& centres = weights.tensors.at("centres").values;
  std::vector<double> whole(kWhole, 0.0);
  for (std::size_t first = 0; first < bytes.size(); first += kChannels) {
    std::vector<double> cell(bytes.begin() + static_cast<std::ptrdiff_t>(first),
                             bytes.begin() + static_cast<std::ptrdiff_t>(first + kChannels));
    MakeUnit(&cell, 0, kChannels);
    std::vector<double> shares(kClusters, 0.0);
    double sum = 0.0;
    for (std::size_t k = 0; k < kClusters; ++k) {
      for (std::size_t i = 0; i < kChannels; ++i) shares[k] += assign[k * kChannels + i] * cell[i];
      shares[k] = std::exp(shares[k]);
      sum += shares[k];
    }
    for (std::size_t k = 0; k < kClusters; ++k) {
      for (std::size_t i = 0; i < kChannels; ++i) {
        whole[k * kChannels + i] += shares[k] / sum * (cell[i] - centres[k * kChannels + i]);
      }
    }
  }
  for (std::size_t k = 0; k < kClusters; ++k) MakeUnit(&whole, k * kChannels, kChannels);
  MakeUnit(&whole, 0, kWhole);
  std::vector<double> numbers(kSize, 0.0);
  for (std::size_t row = 0; row < kSize; ++row) {
    for (std::size_t i = 0; i < kWhole; ++i) {
      numbers[row] += (whole[i] - weights.tensors.at("mean").values[i]) *
                      weights.tensors.at("projection").values[row * kWhole + i];
    }
  }
  MakeUnit(&numbers, 0, kSize);
  return numbers;
}

PictureDescriptor Described(const SeqVlad& model, const std::vector<std::uint8_t>& cells) {
  SequenceModel::Sum sum;
  model.Add(cells, &sum);
  return model.Describe(sum);
}

TEST(SeqVlad, IsTheFormula) {
  const TensorFile weights = SomeWeights();
  const SeqVlad model(weights, "test");
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    const auto cells = Cells(12, seed);
    const PictureDescriptor told = Described(model, cells);
    const std::vector<double> expected = DescribedPlainly(weights, cells);
    for (std::size_t i = 0; i < kSize; ++i) {
      EXPECT_NEAR(told[i] / static_cast<double>(kDescriptorUnit), expected[i], 2e-3) << i;
    }
  }
}

TEST(SeqVlad, HasItsProjectionInBytesToo) {
  TensorFile weights = SomeWeights();
  const SeqVlad wide(weights, "test");
  QuantisedNet bytes;
  QuantisedLayer& layer = bytes.layers[kProjection];
  layer.outputs = kSize;
  layer.inputs = kWhole;
  layer.bias.resize(kSize);
  layer.scale.assign(kSize, 0.004f);
  for (const float value : weights.tensors.at(kProjection).values) {
    layer.weights.push_back(static_cast<std::int16_t>(
        std::clamp(std::nearbyint(value / layer.scale.front()), -127.0f, 127.0f)));
  }
  weights.tensors.erase(kProjection);
  SetQuantised(bytes, &weights);
  const SeqVlad narrow(weights, "test");
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    const auto cells = Cells(12, seed);
    EXPECT_GT(Cosine(Described(narrow, cells), Described(wide, cells)), 0.999) << seed;
  }
  layer.inputs = kWhole / 2;
  layer.outputs = 2 * kSize;
  layer.scale.resize(2 * kSize, 0.004f);
  layer.bias.resize(2 * kSize);
  SetQuantised(bytes, &weights);
  EXPECT_THROW(SeqVlad(weights, "bad.safetensors"), sim::FileError);
  SetQuantised({}, &weights);
  EXPECT_THROW(SeqVlad(weights, "bad.safetensors"), sim::FileError);
}

TEST(SeqVlad, KnowsNeitherOrderNorNumberOfPictures) {
  const SeqVlad model(SomeWeights(), "test");
  const auto a = Cells(12, 1);
  const auto b = Cells(12, 2);
  SequenceModel::Sum forth;
  model.Add(a, &forth);
  model.Add(b, &forth);
  SequenceModel::Sum back;
  model.Add(b, &back);
  model.Add(a, &back);
  EXPECT_EQ(model.Describe(forth), model.Describe(back));
  SequenceModel::Sum often;
  for (int i = 0; i < 5; ++i) model.Add(a, &often);
  EXPECT_GT(Cosine(model.Describe(often), Described(model, a)), 0.9998);
}

TEST(SeqVlad, BadWeightsAreRefused) {
  TensorFile weights = SomeWeights();
  weights.tensors["centres"].shape = {kChannels, kClusters};
  const auto load = [&weights] {
    SeqVlad(weights, "bad.safetensors");
  };
  EXPECT_THAT(load, ThrowsMessage<sim::FileError>(HasSubstr("centres")));
  weights = SomeWeights();
  weights.tensors["mean"].values[3] = std::nanf("");
  EXPECT_THAT(load, ThrowsMessage<sim::FileError>(HasSubstr("mean")));
  weights.metadata.clear();
  EXPECT_THAT(load, ThrowsMessage<sim::FileError>(HasSubstr("descriptor of sequences")));
}

}  // namespace
}  // namespace bulletnav::agent
