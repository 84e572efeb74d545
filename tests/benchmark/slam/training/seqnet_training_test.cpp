// SPDX-License-Identifier: MIT
#include "benchmark/slam/training/seqnet_training.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/base/error.h"
#include "sim/base/files.h"
#include "sim/config/yaml_reader.h"
#include "tests/benchmark/slam/training/random_walk.h"
#include "tests/benchmark/slam/training/resumes.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;
using tests::RandomWalk;
using tests::Watcher;

SeqNetTrainConfig TinyConfig(const fs::path& out) {
  SeqNetTrainConfig config;
  config.out = out.string();
  config.model = {3};
  config.queries = 2;
  config.negatives = 3;
  config.steps = 6;
  config.validate_every = 2;
  config.optimiser.warmup_steps = 1;
  return config;
}

void Train(const SeqNetTrainConfig& config, TrainObserver* observer) {
  auto training = std::make_unique<SeqNetTraining>(
      config, SequenceWalks{{RandomWalk(1), RandomWalk(20)}, {RandomWalk(40)}});
  RunTraining(TrainJob::Of<SeqNetTraining>(config, std::move(training)), observer);
}

TEST(SeqNetTraining, ResumedIsTheSameAsUninterruptedBitForBit) {
  const tests::TemporaryFolder folder;
  const Measures whole =
      tests::ExpectResumesToTheSameBits(TinyConfig("unused"), folder.path(), Train);
  EXPECT_GT(whole.at("ap"), 0.9);
}

TEST(SeqNetTraining, BeginsAsTheMeanAndMovesOn) {
  const tests::TemporaryFolder folder;
  SeqNetTrainConfig config = TinyConfig(folder.path() / "out");
  config.steps = 30;
  config.margin = 1.0;  // nothing is far enough apart
  config.optimiser.learning_rate = 1e-2;
  Watcher watcher;
  Train(config, &watcher);
  const auto file = folder.path() / "out/weights.safetensors";
  const SequenceWalk walk = RandomWalk(40);
  const auto three = std::span(walk.descriptors).first(3);
  const SeqNetNet untrained({3}, tests::kWalkChannels);
  SaveSeqNet(untrained, {3}, {}, folder.path() / "mean.safetensors");
  const auto mean = agent::LoadSeqNetFilter(folder.path() / "mean.safetensors");
  EXPECT_GT(agent::Cosine(mean->Describe(three), agent::MeanDirection(three)), 0.9999);
  EXPECT_LT(agent::Cosine(agent::LoadSeqNetFilter(file)->Describe(three), mean->Describe(three)),
            0.999);
}

TEST(SeqNetTraining, IntegersSayWhatTheNetworkSays) {
  const tests::TemporaryFolder folder;
  const SequenceWalk walk = RandomWalk(3);
  SeqNetNet net({3}, tests::kWalkChannels);
  const torch::NoGradGuard no_grad;
  sim::Rng rng(4, "weights");
  for (torch::Tensor parameter : net.parameters()) {
    auto* numbers = parameter.data_ptr<float>();
    for (std::int64_t i = 0; i < parameter.numel(); ++i) {
      numbers[i] += 0.2f * static_cast<float>(rng.Normal());
    }
  }
  const auto file = folder.path() / "f.safetensors";
  SaveSeqNet(net, {3}, {}, file);
  const auto filter = agent::LoadSeqNetFilter(file);
  for (std::size_t first = 0; first < 60; first += 7) {
    const auto three = std::span(walk.descriptors).subspan(first, 3);
    torch::Tensor rows = torch::zeros({1, 3, tests::kWalkChannels});
    for (int k = 0; k < 3; ++k) {
      for (int i = 0; i < tests::kWalkChannels; ++i) {
        rows[0][k][i] = three[static_cast<std::size_t>(k)][static_cast<std::size_t>(i)];
      }
    }
    const torch::Tensor expected = net.forward(rows / agent::kDescriptorUnit);
    const agent::PictureDescriptor told = filter->Describe(three);
    double cosine = 0.0;
    for (int i = 0; i < tests::kWalkChannels; ++i) {
      cosine += expected[0][i].item<double>() * told[static_cast<std::size_t>(i)] /
                agent::kDescriptorUnit;
    }
    EXPECT_GT(cosine, 0.999) << first;
  }
}

TEST(SeqNetTrainConfig, TheShippedOneIsGood) {
  const fs::path file = fs::path(BULLETNAV_CONFIGS) / "train/seqnet.yaml";
  EXPECT_NO_THROW(sim::LoadYamlText<SeqNetTrainConfig>(sim::ReadTextFile(file), file).Validate());
  SeqNetTrainConfig config = TinyConfig("unused");
  config.frames = 6;
  EXPECT_THROW(config.Validate(), sim::Error);
}

}  // namespace
}  // namespace bulletnav::bench
