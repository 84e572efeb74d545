// SPDX-License-Identifier: MIT
#include "benchmark/training/supervised/mapper_trainer.h"

#include <utility>

#include <fmt/core.h>

#include "agent/perception/mapper_net.h"
#include "agent/perception/one_thread.h"
#include "benchmark/training/core/learner.h"
#include "benchmark/training/supervised/augment.h"
#include "benchmark/training/supervised/batch_tensors.h"
#include "benchmark/training/supervised/mapper_loss.h"
#include "benchmark/training/supervised/mapper_metrics.h"

namespace bulletnav::bench {
namespace {

/// The body that took the panoramas.
agent::Rig RigOf(const MapperTrainConfig& config) {
  agent::Rig rig;
  if (!config.data) return rig;
  rig.panorama = config.data->panorama;
  rig.camera_height = config.data->body.camera_height;
  return rig;
}

class MapperLearner final : public Learner {
 public:
  MapperLearner(const MapperTrainConfig& config, SupervisedData data)
      : config_(config),
        data_(std::move(data)),
        rng_(config.seed, "train_mapper"),
        net_(config.model, config.seed) {}

  torch::nn::Module& net() override { return net_; }

  torch::Tensor Loss(const LaneWork& work) override {
    TrueFreeSpace truth(RigOf(config_));
    std::vector<torch::Tensor> inputs;
    std::vector<torch::Tensor> labels;
    for (int i = 0; i < work.count; ++i) {
      const std::uint64_t number = work.first + static_cast<std::uint64_t>(i);
      PairBatch batch = data_.train.Batch(number);
      batch.Check();
      Augment(config_.augment, rng_.Fork("augment", number), &batch);
      inputs.push_back(InputOf(config_.model.seeing(), &batch));
      labels.push_back(FreeSpaceLabels(batch, &truth));
    }
    const torch::Tensor answers =
        net_.forward(at::cat(inputs), at::detail::createCPUGenerator(work.seed));
    return LossesOf(answers, at::cat(labels), config_.obstacle_weight).Total();
  }

  Measures Validate(sim::WorkerPool* pool) override {
    const int count = config_.validation_batches;
    struct Answers {
      torch::Tensor told;
      torch::Tensor truth;
    };
    std::vector<Answers> answers(static_cast<std::size_t>(count));
    pool->ForEach(count, [&](int i, int) {
      const torch::NoGradGuard no_grad;
      agent::StayInThisThread();
      TrueFreeSpace truth(RigOf(config_));
      PairBatch batch = data_.validation.Batch(static_cast<std::uint64_t>(i));
      batch.Check();
      answers[static_cast<std::size_t>(i)] = {net_.forward(InputOf(config_.model.seeing(), &batch)),
                                              FreeSpaceLabels(batch, &truth)};
    });
    MapperSums sums;
    for (const Answers& one : answers) sums.Add(one.told, one.truth, config_.obstacle_weight);
    return Measures::Of(sums.Means());
  }

  void Save(std::map<std::string, std::string> notes,
            const std::filesystem::path& file) const override {
    agent::SaveMapper(net_, std::move(notes), agent::StoredType::kBfloat16, file);
  }

 private:
  MapperTrainConfig config_;
  SupervisedData data_;
  sim::Rng rng_;
  agent::MapperNet net_;
};

std::string Describe(const Measures& m) {
  return fmt::format(
      "loss {:.3f}; explored IoU {:.3f}; obstacles IoU {:.3f}, to a cell: precision {:.3f}, "
      "recall {:.3f}; F1 to 1, 2, 3.2 m: {:.2f}, {:.2f}, {:.2f}",
      m.at("loss"), m.at("explored_iou"), m.at("obstacle_iou"), m.at("obstacle_precision"),
      m.at("obstacle_recall"), m.at("obstacle_f1_1m"), m.at("obstacle_f1_2m"),
      m.at("obstacle_f1_3m"));
}

}  // namespace

TrainTask MapperTask(const MapperTrainConfig& config, const SupervisedData& data) {
  TrainTask task = SupervisedTask(config);
  task.name = "mapper";
  task.make = [config, data] {
    return std::make_unique<MapperLearner>(config, data);
  };
  task.title = "The mapper from colour";
  task.describe = Describe;
  task.curves_label = "validation";
  task.curves = {{"explored, IoU", "explored_iou"},
                 {"obstacles to 1 m, F1", "obstacle_f1_1m"},
                 {"obstacles to 2 m, F1", "obstacle_f1_2m"},
                 {"obstacles to 3.2 m, F1", "obstacle_f1_3m"}};
  return task;
}

namespace {

struct MapperTrainer {
  static constexpr std::string_view kName = "mapper";
  using Config = MapperTrainConfig;
  static TrainTask Prepare(const Config& config, const TrainerContext& context) {
    return MapperTask(config, LoadSupervisedData(config, true, context));
  }
};

const TrainerRegistration<MapperTrainer> registration;

}  // namespace

}  // namespace bulletnav::bench
