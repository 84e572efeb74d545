// SPDX-License-Identifier: MIT
#include "agent/slam/descriptors/picture_describer.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "agent/integer/quantised_file.h"
#include "agent/slam/descriptors/descriptor_net.h"
#include "agent/slam/descriptors/shrink_picture.h"
#include "sim/base/error.h"
#include "sim/math/rng.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::agent {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr int kWidth = 160;
constexpr int kHeight = 120;

DescriptorConfig Small() {
  DescriptorConfig config;
  config.width = 16;
  config.rows = 48;
  config.size = 32;
  config.precision = Precision::kFloat32;
  return config;
}

/// Coloured boxes.
std::vector<std::uint8_t> Boxes(std::uint64_t seed) {
  sim::Rng rng(seed, "boxes");
  std::vector<std::uint8_t> color(std::size_t{kWidth} * kHeight * 3);
  for (int box = 0; box < 40; ++box) {
    const int top = rng.Between(0, kHeight - 20);
    const int left = rng.Between(0, kWidth - 30);
    const int paint = rng.Between(0, 0xffffff);
    for (int i = 0; i < 20 * 30; ++i) {
      const int pixel = (top + i / 30) * kWidth + left + i % 30;
      for (int c = 0; c < 3; ++c) {
        color[static_cast<std::size_t>(3 * pixel + c)] =
            static_cast<std::uint8_t>(paint >> (8 * c));
      }
    }
  }
  return color;
}

std::vector<std::uint8_t> Shrunk(std::uint64_t seed) {
  const DescriptorConfig config = Small();
  return ShrinkPicture(Boxes(seed), kWidth, kHeight, config.rows, config.cols());
}

torch::Tensor Inputs(int count) {
  std::vector<std::uint8_t> pictures;
  for (int i = 0; i < count; ++i) {
    const auto one = Shrunk(static_cast<std::uint64_t>(i));
    pictures.insert(pictures.end(), one.begin(), one.end());
  }
  return DescriptorInput(Small(), pictures);
}

class PictureDescriberTest : public testing::Test {
 protected:
  PictureDescriberTest() : net_(Small(), 1) {
    net_.train();
    const torch::NoGradGuard no_grad;
    const torch::Tensor inputs = Inputs(8);
    for (int i = 0; i < 8; ++i) net_.forward(inputs);  // running means
    net_.eval();
  }

  DescriptorNet net_;
  tests::TemporaryFolder folder_;
};

TEST_F(PictureDescriberTest, SaysNearlyWhatTheNetworkSays) {
  const torch::NoGradGuard no_grad;
  PictureDescriber describer(Quantise(net_, Inputs(16)), Small());
  const torch::Tensor told = net_.forward(Inputs(12));
  for (int i = 0; i < 12; ++i) {
    const PictureDescriptor whole =
        describer.Describe(Boxes(static_cast<std::uint64_t>(i)), kWidth, kHeight);
    double cosine = 0.0;
    for (int k = 0; k < 32; ++k) {
      cosine += told[i][k].item<double>() * whole[static_cast<std::size_t>(k)] / kDescriptorUnit;
    }
    EXPECT_GT(cosine, 0.995) << i;
    EXPECT_NEAR(Cosine(whole, whole), 1.0, 1e-3);
  }
}

TEST_F(PictureDescriberTest, AllInstructionSetsGiveTheSameBytes) {
  const QuantisedNet quantised = Quantise(net_, Inputs(8));
  PictureDescriber first(quantised, Small());
  for (const IntegerKernels* kernels : SupportedIntegerKernels()) {
    PictureDescriber describer(quantised, Small());
    describer.Use(*kernels);
    for (std::uint64_t i = 0; i < 3; ++i) {
      EXPECT_EQ(describer.DescribeShrunk(Shrunk(i)), first.DescribeShrunk(Shrunk(i)))
          << kernels->name;
    }
  }
}

TEST_F(PictureDescriberTest, ComesBackFromAFile) {
  const auto file = folder_.path() / "descriptor.safetensors";
  SaveDescriptor(net_, {}, StoredType::kFloat32, file);
  EXPECT_THAT(
      [&] {
        LoadPictureDescriber(file);
      },
      ThrowsMessage<sim::FileError>(HasSubstr("descriptor.safetensors")));
  const QuantisedNet quantised = Quantise(*LoadDescriptor(file), Inputs(8));
  AddQuantised(quantised, file, file);
  PictureDescriber expected(quantised, Small());
  EXPECT_EQ(LoadPictureDescriber(file)->DescribeShrunk(Shrunk(3)),
            expected.DescribeShrunk(Shrunk(3)));
}

TEST_F(PictureDescriberTest, TrainingsGoOnFromItsWeights) {
  const auto file = folder_.path() / "descriptor.safetensors";
  SaveDescriptor(net_, {}, StoredType::kFloat32, file);
  DescriptorNet next(Small(), 77);
  next.eval();
  next.StartFrom(file);
  const torch::NoGradGuard no_grad;
  EXPECT_TRUE(at::equal(next.forward(Inputs(3)), net_.forward(Inputs(3))));

  AddQuantised(Quantise(net_, Inputs(4)), file, file);
  EXPECT_NO_THROW(next.StartFrom(file));
  KeepIntegersAlone(file, file);
  EXPECT_THROW(next.StartFrom(file), sim::FileError);
  DescriptorConfig other = Small();
  other.size *= 2;
  SaveDescriptor(DescriptorNet(other, 1), {}, StoredType::kFloat32, file);
  EXPECT_THAT(
      [&] {
        next.StartFrom(file);
      },
      ThrowsMessage<sim::FileError>(HasSubstr("of another width or size")));
}

TEST_F(PictureDescriberTest, OtherWeightsAreRefused) {
  const auto file = folder_.path() / "other.safetensors";
  TensorFile content;
  content.metadata["mapper"] = "{}";
  content.tensors["weight"] = {{1}, {0.5f}};
  WriteTensorFile(file, content);
  EXPECT_THAT(
      [&] {
        LoadPictureDescriber(file);
      },
      ThrowsMessage<sim::FileError>(HasSubstr("does not hold the weights of a descriptor")));
  QuantisedNet without = Quantise(net_, Inputs(4));
  without.layers.erase("out");
  EXPECT_THROW(PictureDescriber(without, Small()), sim::Error);
  EXPECT_THROW(net_.StartFrom(file), sim::FileError);
}

TEST(DescriptorConfig, BadShapesAreRefused) {
  DescriptorConfig config;
  EXPECT_NO_THROW(config.Validate());
  EXPECT_EQ(config.cols(), 128);
  config.rows = 50;
  EXPECT_THROW(config.Validate(), sim::Error);
  config = {};
  config.width = 20;
  EXPECT_THROW(config.Validate(), sim::Error);
  config = {};
  config.size = 2000;
  EXPECT_THROW(config.Validate(), sim::Error);
}

}  // namespace
}  // namespace bulletnav::agent
