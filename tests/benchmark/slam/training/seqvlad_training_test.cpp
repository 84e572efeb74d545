// SPDX-License-Identifier: MIT
#include "benchmark/slam/training/seqvlad_training.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "agent/slam/descriptors/seqvlad.h"
#include "benchmark/slam/training/seqvlad_net.h"
#include "sim/base/error.h"
#include "sim/base/files.h"
#include "sim/config/yaml_reader.h"
#include "sim/math/rng.h"
#include "tests/benchmark/slam/training/random_walk.h"
#include "tests/benchmark/slam/training/resumes.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;
using tests::RandomWalk;

constexpr int kChannels = tests::kWalkChannels;

SeqVladTrainConfig TinyConfig(const fs::path& out) {
  SeqVladTrainConfig config;
  config.out = out.string();
  config.model = {4, kChannels, 16};
  config.queries = 2;
  config.negatives = 3;
  config.longest = 8;
  config.steps = 6;
  config.validate_every = 2;
  config.optimiser.warmup_steps = 1;
  return config;
}

TEST(ShareCovisible, CountsFramesOfTheFirst) {
  const SequenceWalk walk = RandomWalk(1);
  EXPECT_EQ(ShareCovisible(walk, {0, 5}, {90, 5}), 1.0);
  EXPECT_EQ(ShareCovisible(walk, {0, 5}, {15, 5}), 0.0);
  EXPECT_EQ(ShareCovisible(walk, {10, 10}, {90, 5}), 0.5);
}

TEST(MainDirections, AreOrthonormalAndHoldMostOfWhatDiffers) {
  torch::Tensor rows = torch::zeros({40, 12});
  sim::Rng rng(2, "rows");
  for (int i = 0; i < 40; ++i) {
    const auto a = static_cast<float>(rng.Normal());
    const auto b = static_cast<float>(rng.Normal());
    for (int k = 0; k < 12; ++k)
      rows[i][k] = 3.0f + a * static_cast<float>(k) + b * (k % 2 == 0 ? 1.0f : -1.0f);
  }
  const MainDirections directions = MainDirectionsOf(rows, 2);
  const torch::Tensor products = at::matmul(directions.projection, directions.projection.t());
  EXPECT_TRUE(at::allclose(products, torch::eye(2), 1e-3, 1e-3));
  const torch::Tensor off = rows - directions.mean;
  const torch::Tensor kept =
      at::matmul(at::matmul(off, directions.projection.t()), directions.projection);
  EXPECT_TRUE(at::allclose(kept, off, 1e-3, 1e-3));
}

void Train(const SeqVladTrainConfig& config, TrainObserver* observer) {
  auto training = std::make_unique<SeqVladTraining>(
      config, SequenceWalks{{RandomWalk(1), RandomWalk(20)}, {RandomWalk(40)}});
  RunTraining(TrainJob::Of<SeqVladTraining>(config, std::move(training)), observer);
}

TEST(SeqVladTraining, ResumedIsTheSameAsUninterruptedBitForBit) {
  const tests::TemporaryFolder folder;
  const Measures whole =
      tests::ExpectResumesToTheSameBits(TinyConfig("unused"), folder.path(), Train);
  EXPECT_GT(whole.at("ap"), 0.9);
}

/// All directions are kept here, so that integers say what the network says.
TEST(SeqVladTraining, IntegersSayNearlyWhatTheNetworkSays) {
  const tests::TemporaryFolder folder;
  const SequenceWalk walk = RandomWalk(3);
  SeqVladNet net({4, kChannels, 64}, 1);
  Eigen::MatrixXf cells(200, kChannels);
  for (int row = 0; row < cells.rows(); ++row) {
    for (int i = 0; i < kChannels; ++i) {
      cells(row, i) = walk.cells[static_cast<std::size_t>(row * kChannels + i)];
    }
    cells.row(row).normalize();
  }
  sim::Rng rng(4, "start");
  net.StartFrom(cells, &rng);
  const torch::NoGradGuard no_grad;
  const auto file = folder.path() / "s.safetensors";
  SaveSeqVlad(net, {torch::zeros({64}), torch::eye(64)}, {}, file);
  const auto model = agent::LoadSeqVlad(file);
  for (int first = 0; first < 60; first += 7) {
    agent::SequenceModel::Sum sum;
    model->Add(walk.Frames(first, 3), &sum);
    const agent::PictureDescriptor told = model->Describe(sum);
    const torch::Tensor expected = net.forward(CellDirections(walk.Frames(first, 3), 1, kChannels));
    double cosine = 0.0;
    for (int i = 0; i < 64; ++i) {
      cosine += expected[0][i].item<double>() * told[static_cast<std::size_t>(i)] /
                agent::kDescriptorUnit;
    }
    EXPECT_GT(cosine, 0.99) << first;
  }
}

TEST(SeqVladTrainConfig, TheShippedOnesAreGood) {
  for (const char* name : {"seqvlad.yaml", "seqvlad_lengths.yaml"}) {
    const fs::path file = fs::path(BULLETNAV_CONFIGS) / "train" / name;
    const auto config = sim::LoadYamlText<SeqVladTrainConfig>(sim::ReadTextFile(file), file);
    EXPECT_NO_THROW(config.Validate());
  }
  SeqVladTrainConfig config = TinyConfig("unused");
  config.longest = 2;
  EXPECT_THROW(config.Validate(), sim::Error);
}

}  // namespace
}  // namespace bulletnav::bench
