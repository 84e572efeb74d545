// SPDX-License-Identifier: MIT
#include "benchmark/slam/training/place_training.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "agent/slam/descriptors/picture_describer.h"
#include "benchmark/slam/training/place_loss.h"
#include "sim/base/error.h"
#include "sim/base/files.h"
#include "sim/config/yaml_reader.h"
#include "tests/benchmark/slam/training/random_views.h"
#include "tests/benchmark/slam/training/resumes.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;
using tests::RandomViews;

/// The formula, one view after the other.
double LossPlainly(const torch::Tensor& cosines, const torch::Tensor& covisibility,
                   const SimilarityLossSpec& spec) {
  const std::int64_t n = cosines.size(0);
  const auto at = [](const torch::Tensor& x, std::int64_t a, std::int64_t b) {
    return x[a][b].item<double>();
  };
  double sum = 0.0;
  for (std::int64_t a = 0; a < n; ++a) {
    double least = 10.0;
    double most = -10.0;
    for (std::int64_t b = 0; b < n; ++b) {
      if (a == b) continue;
      if (at(covisibility, a, b) >= 0.3) least = std::min(least, at(cosines, a, b));
      if (at(covisibility, a, b) <= 0.1) most = std::max(most, at(cosines, a, b));
    }
    double same = 1.0;
    double unlike = 1.0;
    for (std::int64_t b = 0; b < n; ++b) {
      const double s = at(cosines, a, b);
      if (a == b) continue;
      if (at(covisibility, a, b) >= 0.3 && s - spec.margin < most) {
        same += std::exp(-spec.alpha * (s - spec.base));
      }
      if (at(covisibility, a, b) <= 0.1 && s + spec.margin > least) {
        unlike += std::exp(spec.beta * (s - spec.base));
      }
    }
    sum += std::log(same) / spec.alpha + std::log(unlike) / spec.beta;
  }
  return sum / static_cast<double>(n);
}

TEST(SimilarityLoss, IsTheFormula) {
  sim::Rng rng(1, "loss");
  for (const double margin : {0.1, 0.0, 2.0}) {
    torch::Tensor descriptors = torch::empty({10, 6});
    for (int i = 0; i < 60; ++i)
      descriptors.data_ptr<float>()[i] = static_cast<float>(rng.Normal());
    descriptors = descriptors / descriptors.norm(2, {1}, true);
    torch::Tensor covisibility = torch::zeros({10, 10});
    for (int a = 0; a < 10; ++a) {
      for (int b = 0; b < a; ++b) {
        const float share = static_cast<float>(rng.Uniform(0.0, 0.5));
        covisibility[a][b] = covisibility[b][a] = share;
      }
    }
    SimilarityLossSpec spec;
    spec.margin = margin;
    spec.base = 0.2;
    const torch::Tensor cosines = at::matmul(descriptors, descriptors.t());
    EXPECT_NEAR(SimilarityLoss(descriptors, covisibility, spec).item<double>(),
                LossPlainly(cosines, covisibility, spec), 1e-4);
  }
}

PlaceTrainConfig TinyConfig(const fs::path& out) {
  PlaceTrainConfig config;
  config.out = out.string();
  config.model.width = 16;
  config.model.rows = 48;
  config.model.size = 16;
  config.model.precision = agent::Precision::kFloat32;
  config.optimiser.learning_rate = 2e-3;
  config.optimiser.warmup_steps = 1;
  config.places = 2;
  config.scenes = 1;
  config.lanes = 2;
  config.steps = 6;
  config.validate_every = 2;
  return config;
}

void Train(const PlaceTrainConfig& config, TrainObserver* observer) {
  auto training = std::make_unique<PlaceTraining>(
      config, std::vector<PlaceViews>{RandomViews(4, 2, 1), RandomViews(4, 2, 2)},
      std::vector<PlaceViews>{RandomViews(4, 2, 3)});
  RunTraining(TrainJob::Of<PlaceTraining>(config, std::move(training)), observer);
}

TEST(PlaceTraining, ResumedIsTheSameAsUninterruptedBitForBit) {
  const tests::TemporaryFolder folder;
  tests::ExpectResumesToTheSameBits(TinyConfig("unused"), folder.path(), Train);
  EXPECT_EQ(sim::ReadTextFile(folder.path() / "parts/curves.csv"),
            sim::ReadTextFile(folder.path() / "whole/curves.csv"));
  // What was written describes pictures.
  const auto describer = agent::LoadPictureDescriber(folder.path() / "parts/weights.safetensors");
  const PlaceViews views = RandomViews(4, 2, 1);
  const auto descriptor = describer->Describe(views.picture(0), kViewCols, kViewRows);
  EXPECT_EQ(descriptor.size(), 16u);
  EXPECT_NEAR(agent::Cosine(descriptor, descriptor), 1.0, 2e-3);
}

TEST(PlaceTraining, LearnsToTellPlaces) {
  PlaceTrainConfig config = TinyConfig("unused");
  config.places = 4;
  config.lanes = 1;
  PlaceTraining training(config, {RandomViews(6, 3, 1)}, {RandomViews(6, 3, 1)});
  training.net().train();
  const auto adam = MakeTorchAdam(training.net(), {});
  double first = 0.0;
  double last = 0.0;
  for (int step = 0; step < 12; ++step) {
    last = training.Learn({step, 2e-3, adam.get()});
    if (step == 0) first = last;
  }
  EXPECT_LT(last, first);
}

TEST(PlaceTrainConfig, TheShippedOneIsGood) {
  const fs::path file = fs::path(BULLETNAV_CONFIGS) / "train/place.yaml";
  const auto config = sim::LoadYamlText<PlaceTrainConfig>(sim::ReadTextFile(file), file);
  EXPECT_NO_THROW(config.Validate());
  EXPECT_EQ(ValidationData(config).houses->split, "val");
  EXPECT_EQ(config.task, "place");
}

TEST(PlaceTrainConfig, BadSettingsAreRefused) {
  PlaceTrainConfig config = TinyConfig("unused");
  EXPECT_NO_THROW(config.Validate());
  config.places = 5;
  config.scenes = 2;
  EXPECT_THROW(config.Validate(), sim::Error);
  config = TinyConfig("unused");
  config.loss.alpha = 0.0;
  EXPECT_THROW(config.loss.Validate(), sim::Error);
  EXPECT_THROW(ValidationData(config), sim::Error);
}

}  // namespace
}  // namespace bulletnav::bench
