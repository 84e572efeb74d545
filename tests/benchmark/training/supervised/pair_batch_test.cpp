// SPDX-License-Identifier: MIT
#include "benchmark/training/supervised/pair_batch.h"

#include <gtest/gtest.h>

#include "benchmark/training/supervised/augment.h"
#include "benchmark/training/supervised/train_config.h"
#include "sim/base/error.h"
#include "sim/config/yaml_writer.h"
#include "sim/math/pose.h"
#include "tests/benchmark/training/supervised/bar_world.h"

namespace bulletnav::bench {
namespace {

using tests::BarBatch;
using tests::Stand;

// Stands whose neighbours are not near a border between two directions.
std::vector<Stand> SomeStands() {
  return {{0.3, -0.4, 0.2}, {1.9, 0.7, 2.0}, {-1.5, 1.6, -2.5}};
}

TEST(TurnPanorama, IsWhatATurnedCameraSees) {
  for (const int twelfths : {0, 3, 6, 9}) {
    std::vector<Stand> stands = SomeStands();
    PairBatch rolled = BarBatch(stands);
    TurnPanorama(1, twelfths, &rolled);
    stands[1].heading += twelfths * sim::kPi / 6.0;
    const PairBatch seen = BarBatch(stands);
    EXPECT_EQ(rolled.color, seen.color) << twelfths;
    EXPECT_EQ(rolled.depth, seen.depth) << twelfths;
  }
}

TEST(TurnPanorama, RollsToTheNearestColumn) {
  for (int twelfths = 0; twelfths < 12; ++twelfths) {
    std::vector<Stand> stands = SomeStands();
    PairBatch rolled = BarBatch(stands);
    TurnPanorama(1, twelfths, &rolled);
    stands[1].heading += twelfths * sim::kPi / 6.0;
    const PairBatch seen = BarBatch(stands);
    int differences = 0;
    for (std::size_t i = 0; i < seen.depth.size(); ++i)
      differences += seen.depth[i] != rolled.depth[i];
    EXPECT_LE(differences, 8 * 128) << "two edges of four bars";
  }
}

TEST(TurnPanorama, TurnsTheLabelsOfTheSourceAndNoOthers) {
  for (int twelfths = 0; twelfths < 12; ++twelfths) {
    std::vector<Stand> stands = SomeStands();
    PairBatch rolled = BarBatch(stands);
    TurnPanorama(1, twelfths, &rolled);
    stands[1].heading += twelfths * sim::kPi / 6.0;
    const PairBatch seen = BarBatch(stands);
    EXPECT_EQ(rolled.explorable, seen.explorable);
    EXPECT_EQ(rolled.direction, seen.direction);
    EXPECT_EQ(rolled.same_node, seen.same_node);
    EXPECT_EQ(rolled.distance_score, seen.distance_score);
    for (std::size_t i = 0; i < seen.scores.size(); ++i) {
      EXPECT_NEAR(rolled.scores[i], seen.scores[i], 1e-5);
    }
  }
}

TEST(Augment, FollowsFromItsGeneratorAndKeepsThePictures) {
  const PairBatch before = BarBatch(SomeStands());
  PairBatch a = before;
  PairBatch b = before;
  PairBatch none = before;
  Augment({}, sim::Rng(1, "augment"), DepthUse::kInput, &a);
  Augment({}, sim::Rng(1, "augment"), DepthUse::kInput, &b);
  Augment({false, 0.0, 0.0, 0.0, {}, {}}, sim::Rng(1, "augment"), DepthUse::kInput, &none);
  EXPECT_EQ(a.color, b.color);
  EXPECT_EQ(a.direction, b.direction);
  EXPECT_NE(a.color, before.color);
  EXPECT_EQ(none.color, before.color);
  EXPECT_EQ(none.direction, before.direction);
}

/// A batch with depth: a wall two metres away on all sides.
PairBatch BatchWithDepth() {
  PairBatch batch = BarBatch(SomeStands());
  batch.depth.assign(batch.color.size() / 3, 2.0f);
  return batch;
}

TEST(Augment, GivesAShareOfThePanoramasSensorNoise) {
  AugmentSpec spec{false, 0.0, 0.0, 0.0, 0.5, {}};
  const PairBatch before = BatchWithDepth();
  const std::size_t pixels = before.depth.size() / static_cast<std::size_t>(before.count);
  int noisy = 0;
  int noisy_depth = 0;
  constexpr int kRounds = 20;
  for (std::uint64_t round = 0; round < kRounds; ++round) {
    PairBatch batch = before;
    Augment(spec, sim::Rng(round, "augment"), DepthUse::kInput, &batch);
    EXPECT_EQ(batch.scores, before.scores);
    for (std::size_t i = 0; i < static_cast<std::size_t>(before.count); ++i) {
      const auto differs = [&](const auto& now, const auto& then, std::size_t size) {
        const auto first = static_cast<std::ptrdiff_t>(i * size);
        return !std::equal(now.begin() + first,
                           now.begin() + first + static_cast<std::ptrdiff_t>(size),
                           then.begin() + first);
      };
      noisy += differs(batch.color, before.color, 3 * pixels) ? 1 : 0;
      noisy_depth += differs(batch.depth, before.depth, pixels) ? 1 : 0;
    }
  }
  const double all = kRounds * before.count;
  EXPECT_NEAR(noisy / all, 0.5, 0.2);
  EXPECT_NEAR(noisy_depth / all, 0.33, 0.2);
  EXPECT_LE(noisy_depth, noisy);
}

TEST(Augment, SensorNoiseMovesNoOtherDrawsAndSparesTheTruth) {
  AugmentSpec quiet;
  AugmentSpec noisy;
  noisy.sensor_noise = 1.0;
  PairBatch a = BatchWithDepth();
  PairBatch b = BatchWithDepth();
  PairBatch again = BatchWithDepth();
  Augment(quiet, sim::Rng(1, "augment"), DepthUse::kTruth, &a);
  Augment(noisy, sim::Rng(1, "augment"), DepthUse::kTruth, &b);
  Augment(noisy, sim::Rng(1, "augment"), DepthUse::kTruth, &again);
  EXPECT_EQ(a.depth, b.depth);
  EXPECT_EQ(a.direction, b.direction);
  EXPECT_NE(a.color, b.color);
  EXPECT_EQ(b.color, again.color);
}

TEST(TrainConfig, RatesRiseAndFall) {
  OptimiserSpec optimiser;
  optimiser.warmup_steps = 10;
  EXPECT_NEAR(optimiser.RateAt(0, 1000), 5e-5, 1e-9);
  EXPECT_NEAR(optimiser.RateAt(9, 1000), 5e-4, 1e-6);
  EXPECT_NEAR(optimiser.RateAt(500, 1000), 2.5e-4, 1e-9);
  EXPECT_LT(optimiser.RateAt(999, 1000), 1e-8);
  optimiser.schedule = Schedule::kConstant;
  EXPECT_EQ(optimiser.RateAt(999, 1000), 5e-4);
}

TEST(TrainConfig, RefusesWhatCannotTrain) {
  const auto load = [](const std::string& text) {
    return sim::LoadYamlText<TrainConfig>(text, "train.yaml");
  };
  EXPECT_EQ(load("out: x\nmodel: {width: 16}\n").model.width, 16);
  EXPECT_THROW(load("steps: 3\n"), sim::FileError);
  EXPECT_THROW(load("out: x\nsteps: 0\n"), sim::FileError);
  EXPECT_THROW(load("out: x\npanoramas: 1\n"), sim::FileError);
  EXPECT_THROW(load("out: x\noptimiser: {learning_rate: -1}\n"), sim::FileError);
  EXPECT_THROW(load("out: x\nmodel: {rows: 100}\n"), sim::FileError);
  EXPECT_THROW(load("out: x\naugment: {tint: 2}\n"), sim::FileError);
  EXPECT_THROW(load("out: x\naugment: {sensor_noise: 2}\n"), sim::FileError);
  EXPECT_THROW(load("out: x\naugment: {sensor_noise: 1, noise_strength: 9}\n"), sim::FileError);
  EXPECT_EQ(load("out: x\naugment: {sensor_noise: 0.5}\n").augment.sensor_noise.value_or(0.0), 0.5);
  EXPECT_EQ(sim::ToYaml(AugmentSpec()).find("noise"), std::string::npos);
}

}  // namespace
}  // namespace bulletnav::bench
