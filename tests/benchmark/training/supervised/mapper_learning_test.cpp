// SPDX-License-Identifier: MIT
#include <iostream>

#include <gtest/gtest.h>

#include "agent/models/semantic_model.h"
#include "benchmark/training/supervised/mapper_trainer.h"
#include "sim/math/rng.h"
#include "tests/benchmark/training/supervised/watchers.h"
#include "tests/support/panoramas.h"
#include "tests/support/scenes.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::bench {
namespace {

/// Panoramas from random places of a room with a few boxes. What pairs of them have in common plays
/// no part.
class RoomSource final : public BatchSource {
 public:
  RoomSource(int count, std::uint64_t seed) : count_(count), seed_(seed) {
    sim::SceneMesh room = tests::BoxRoom(5, 2.6f, 6);
    tests::AddBox({1.0f, 0, -4.6f}, {1.9f, 0.9f, -4.0f}, {200, 120, 30}, &room);
    tests::AddBox({3.4f, 0, -2.2f}, {3.7f, 1.8f, -1.6f}, {40, 60, 160}, &room);
    scene_ = sim::MakeRenderScene(room, sim::Backend::kEmbree);
  }

  PairBatch Batch(std::uint64_t number) const override {
    sim::Rng rng = sim::Rng(seed_, "room").Fork("batch", number);
    const auto n = static_cast<std::size_t>(count_);
    PairBatch batch;
    batch.count = count_;
    for (std::size_t i = 0; i < n; ++i) {
      const sim::CameraPose camera{{static_cast<float>(rng.Uniform(0.3, 4.7)), 1.25f,
                                    static_cast<float>(rng.Uniform(-5.7, -0.3))},
                                   static_cast<float>(rng.Uniform(-3.14, 3.14))};
      const tests::Panorama p = tests::RenderPanorama(*scene_, {}, camera);
      batch.color.insert(batch.color.end(), p.color.begin(), p.color.end());
      batch.depth.insert(batch.depth.end(), p.depth.begin(), p.depth.end());
    }
    batch.explorable.resize(n * agent::kDirections);
    batch.same_node.resize(n * n);
    batch.direction.resize(n * n);
    batch.distance_score.resize(n * n);
    batch.scores.resize(n * n * agent::kDirections);
    return batch;
  }

 private:
  int count_;
  std::uint64_t seed_;
  std::unique_ptr<const sim::RenderScene> scene_;
};

TEST(TrainMapper, LearnsTheWallsOfARoom) {
  const tests::TemporaryFolder folder;
  MapperTrainConfig config;
  config.out = folder.path();
  config.model.width = 8;
  config.model.rows = 32;
  config.model.features = 64;
  config.model.dropout = 0.0;
  config.optimiser.learning_rate = 3e-3;
  config.optimiser.warmup_steps = 20;
  config.steps = 150;
  config.scenes = 2;
  config.panoramas = 8;
  config.validate_every = config.steps;
  config.validation_batches = 4;
  const RoomSource train(config.panoramas, 1);
  const RoomSource validation(config.panoramas, 2);
  const TrainTask task = MapperTask(config, {train, validation});
  tests::LastMeasures log(task, &std::cout);
  RunTraining(task, &log);
  EXPECT_GT(log.at("explored_iou"), 0.85);
  EXPECT_GT(log.at("obstacle_f1_1m"), 0.5);
  EXPECT_GT(log.at("obstacle_f1_2m"), 0.4);
}

}  // namespace
}  // namespace bulletnav::bench
