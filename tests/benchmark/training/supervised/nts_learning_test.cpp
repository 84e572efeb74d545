// SPDX-License-Identifier: MIT
#include <iostream>

#include <gtest/gtest.h>

#include "benchmark/training/supervised/nts_trainer.h"
#include "tests/benchmark/training/supervised/bar_world.h"
#include "tests/benchmark/training/supervised/watchers.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::bench {
namespace {

TEST(TrainNts, LearnsWhereThingsAreFromBars) {
  const tests::TemporaryFolder folder;
  TrainConfig config;
  config.out = folder.path();
  config.model.width = 8;
  config.model.rows = 32;
  config.model.pair_features = 32;
  config.model.dropout = 0.1;
  config.optimiser.learning_rate = 2e-3;
  config.optimiser.warmup_steps = 20;
  config.steps = 200;
  config.scenes = 2;
  config.panoramas = 8;
  config.pairs = 32;
  config.validate_every = config.steps;
  config.validation_batches = 10;
  tests::BarSource train(config.panoramas, 1);
  tests::BarSource validation(config.panoramas, 2);
  const TrainTask task = NtsTask(config, {train, validation});
  tests::LastMeasures log(task, &std::cout);
  RunTraining(task, &log);
  EXPECT_GT(log.at("connection"), 0.75);
  EXPECT_GT(log.at("direction"), 0.3);
  EXPECT_GT(log.at("direction_near"), 0.6);
  EXPECT_GT(log.at("explorable"), 0.75);
  EXPECT_LT(log.at("distance_error_m"), 0.45);
  EXPECT_GT(log.at("score_choice"), 0.5);
}

}  // namespace
}  // namespace bulletnav::bench
