// SPDX-License-Identifier: MIT
#include "agent/slam/descriptors/seqnet_filter.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/base/error.h"
#include "sim/math/rng.h"

namespace bulletnav::agent {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr int kLength = 3;
constexpr int kSize = 8;

PictureDescriptor SomePicture(std::uint64_t seed) {
  sim::Rng rng(seed, "picture");
  std::vector<std::int64_t> numbers;
  for (int i = 0; i < kSize; ++i) numbers.push_back(std::llround(1000.0 * rng.Normal()));
  return DirectionOf(numbers);
}

TensorFile SomeWeights(double deviation) {
  sim::Rng rng(1, "weights");
  TensorFile weights;
  weights.metadata[kSeqNetKey] = "{length: 3}";
  TensorFile::Tensor filter{{kSize, kLength, kSize}, {}};
  for (int row = 0; row < kSize; ++row) {
    for (int k = 0; k < kLength; ++k) {
      for (int i = 0; i < kSize; ++i) {
        const double even = row == i ? 1.0 / kLength : 0.0;
        filter.values.push_back(static_cast<float>(even + deviation * rng.Normal()));
      }
    }
  }
  TensorFile::Tensor bias{{kSize}, {}};
  for (int i = 0; i < kSize; ++i) {
    bias.values.push_back(static_cast<float>(deviation * rng.Normal()));
  }
  weights.tensors["filter"] = filter;
  weights.tensors["bias"] = bias;
  return weights;
}

/// The same in floats.
std::vector<double> Expected(const TensorFile& weights,
                             const std::vector<PictureDescriptor>& pictures) {
  std::vector<double> numbers;
  double squares = 0.0;
  for (std::size_t row = 0; row < kSize; ++row) {
    double sum = double{weights.tensors.at("bias").values[row]} * kDescriptorUnit;
    for (std::size_t k = 0; k < kLength; ++k) {
      for (std::size_t i = 0; i < kSize; ++i) {
        sum += double{weights.tensors.at("filter").values[(row * kLength + k) * kSize + i]} *
               pictures[k][i];
      }
    }
    numbers.push_back(sum);
    squares += sum * sum;
  }
  for (double& number : numbers) number *= kDescriptorUnit / std::sqrt(squares);
  return numbers;
}

TEST(SeqNetFilter, SaysWhatItsWeightsSay) {
  const TensorFile weights = SomeWeights(0.3);
  const SeqNetFilter filter(weights, "w");
  EXPECT_EQ(filter.length(), kLength);
  EXPECT_EQ(filter.size(), kSize);
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const std::vector<PictureDescriptor> pictures = {
        SomePicture(3 * seed), SomePicture(3 * seed + 1), SomePicture(3 * seed + 2)};
    const PictureDescriptor told = filter.Describe(pictures);
    const std::vector<double> expected = Expected(weights, pictures);
    for (std::size_t i = 0; i < kSize; ++i) EXPECT_NEAR(told[i], expected[i], 4.0);
  }
}

TEST(SeqNetFilter, WithEvenWeightsItIsTheMean) {
  const SeqNetFilter filter(SomeWeights(0.0), "w");
  const std::vector<PictureDescriptor> pictures = {SomePicture(1), SomePicture(2), SomePicture(3)};
  EXPECT_GT(Cosine(filter.Describe(pictures), MeanDirection(pictures)), 0.9999);
}

TEST(SeqNetFilter, WhereADriveBeginsTheFirstPictureStandsForThoseBefore) {
  const SeqNetFilter filter(SomeWeights(0.3), "w");
  const PictureDescriptor first = SomePicture(1);
  const PictureDescriptor second = SomePicture(2);
  EXPECT_EQ(filter.Describe(std::vector{first, second}),
            filter.Describe(std::vector{first, first, second}));
}

std::string ErrorOf(const TensorFile& weights) {
  try {
    SeqNetFilter(weights, "w.safetensors");
    return "none";
  } catch (const sim::FileError& e) {
    return e.what();
  }
}

TEST(SeqNetFilter, OtherWeightsAreRefused) {
  TensorFile weights = SomeWeights(0.1);
  weights.tensors["filter"].shape = {kSize, kSize, kLength};
  EXPECT_THAT(ErrorOf(weights), HasSubstr("w.safetensors:filter: is missing or has another shape"));
  weights = SomeWeights(0.1);
  weights.tensors["filter"].values[3] = NAN;
  EXPECT_THAT(ErrorOf(weights), HasSubstr("too large or none"));
  weights.tensors.erase("bias");
  EXPECT_THAT(ErrorOf(weights), HasSubstr("w.safetensors:bias"));
  weights.metadata[kSeqNetKey] = "{length: 0}";
  EXPECT_THAT(ErrorOf(weights), HasSubstr("length"));
  weights.metadata.clear();
  EXPECT_THAT(ErrorOf(weights), HasSubstr("configs/train/seqnet.yaml"));
}

}  // namespace
}  // namespace bulletnav::agent
