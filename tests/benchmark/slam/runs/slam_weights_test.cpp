// SPDX-License-Identifier: MIT
#include "benchmark/slam/runs/slam_weights.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "agent/models/safetensors.h"
#include "agent/slam/descriptors/descriptor_config.h"
#include "agent/slam/descriptors/seqnet_filter.h"
#include "benchmark/base/file_hash.h"
#include "sim/base/error.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::bench {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

class SlamWeights : public ::testing::Test {
 protected:
  /// A config whose filter over time was learned from the descriptor with this hash.
  SlamConfig WithFilterOf(const std::string& hash) const {
    agent::TensorFile filter;
    filter.metadata[agent::kSeqNetKey] = "length: 1\n";
    if (!hash.empty()) filter.metadata[agent::kDescriptorHashKey] = hash;
    filter.tensors["filter"] = {{2, 1, 2}, {1.0f, 0.0f, 0.0f, 1.0f}};
    filter.tensors["bias"] = {{2}, {0.0f, 0.0f}};
    SlamConfig config;
    config.descriptors = descriptors_.string();
    config.filter = (folder_.path() / "filter.safetensors").string();
    agent::WriteTensorFile(*config.filter, filter);
    return config;
  }

  tests::TemporaryFolder folder_;
  std::filesystem::path descriptors_ = folder_.Write("place.safetensors", "some network");
};

TEST_F(SlamWeights, GoWithTheDescriptorThatTheyWereLearnedFrom) {
  const SlamConfig config = WithFilterOf(FileHash(descriptors_));
  EXPECT_EQ(LoadFilter(config)->size(), 2);
  EXPECT_EQ(LoadSequences(config), nullptr);
  EXPECT_NO_THROW(CheckWeights(config));
}

TEST_F(SlamWeights, OfAnotherDescriptorAreRefused) {
  const SlamConfig config = WithFilterOf("0123456789abcdef");
  const auto message =
      AllOf(HasSubstr("filter.safetensors"), HasSubstr("another descriptor"),
            HasSubstr("place.safetensors"), HasSubstr("configs/train/seqnet.yaml"));
  EXPECT_THAT(
      [&] {
        CheckWeights(config);
      },
      ThrowsMessage<sim::FileError>(message));
}

TEST_F(SlamWeights, ThatDoNotSayWhoseTheyAreAreTaken) {
  EXPECT_NO_THROW(CheckWeights(WithFilterOf("")));
}

}  // namespace
}  // namespace bulletnav::bench
