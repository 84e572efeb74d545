// SPDX-License-Identifier: MIT
#include "benchmark/training/supervised/mapper_training.h"

#include <utility>

#include <fmt/core.h>

#include "agent/integer/integer_mapper.h"
#include "agent/integer/quantised_file.h"
#include "agent/perception/mapper_net.h"
#include "agent/perception/quantise.h"
#include "benchmark/base/shipped_file.h"
#include "benchmark/training/core/registry.h"
#include "benchmark/training/supervised/answer_batches.h"
#include "benchmark/training/supervised/augment.h"
#include "benchmark/training/supervised/batch_tensors.h"
#include "benchmark/training/supervised/calibration.h"
#include "benchmark/training/supervised/learner.h"
#include "benchmark/training/supervised/mapper_loss.h"
#include "benchmark/training/supervised/mapper_metrics.h"
#include "benchmark/training/supervised/model_answers.h"

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
  explicit MapperLearner(const MapperTrainConfig& config)
      : config_(config), rng_(config.seed, "train_mapper"), net_(config.model, config.seed) {
    if (config.start) agent::TakeMapper(ShippedOr(*config.start), &net_);
  }

  torch::nn::Module& net() override { return net_; }

  torch::Tensor Loss(const LaneWork& work) override {
    TrueFreeSpace truth(RigOf(config_));
    std::vector<torch::Tensor> inputs;
    std::vector<torch::Tensor> labels;
    for (int i = 0; i < work.count; ++i) {
      const std::uint64_t number = work.first + static_cast<std::uint64_t>(i);
      PairBatch batch = work.batches->Batch(number);
      batch.Check();
      Augment(config_.augment, rng_.Fork("augment", number), DepthUse::kTruth, &batch);
      inputs.push_back(InputOf(config_.model.seeing(), &batch));
      labels.push_back(FreeSpaceLabels(batch, &truth));
    }
    const torch::Tensor answers =
        net_.forward(at::cat(inputs).to(DeviceOf(net_)), at::detail::createCPUGenerator(work.seed));
    return LossesOf(answers.cpu(), at::cat(labels), config_.obstacle_weight).Total();
  }

  Measures Validate(const BatchSource& batches, int count, sim::WorkerPool* pool) override {
    return MeasuresOf(batches, count, pool, [this](PairBatch* batch) {
      return net_.forward(InputOf(config_.model.seeing(), batch).to(DeviceOf(net_))).cpu();
    });
  }

  std::optional<Measures> Quantise(const QuantiseWork& work) override {
    if (!agent::HasIntegerForm(config_.model)) return std::nullopt;
    const agent::QuantisedNet net = agent::Quantise(
        *agent::LoadMapper(work.file), CalibrationInput(*work.train, config_.model.seeing()));
    agent::AddQuantised(net, work.file, work.file);
    return MeasuresOf(*work.validation, work.count, work.pool, [&](PairBatch* batch) {
      agent::IntegerMapper mapper(net, config_.model.seeing().rows);
      return AnswersOf(&mapper, *batch);
    });
  }

  void Save(std::map<std::string, std::string> notes,
            const std::filesystem::path& file) const override {
    agent::SaveMapper(net_, std::move(notes), agent::StoredType::kBfloat16, file);
  }

 private:
  /// Of what answer(batch) gives for batches number 0 on.
  template <class F>
  Measures MeasuresOf(const BatchSource& batches, int count, sim::WorkerPool* pool,
                      const F& answer) const {
    struct Answered {
      torch::Tensor told;
      torch::Tensor truth;
    };
    const auto all = AnswerBatches(batches, count, pool, [&](PairBatch* batch) {
      TrueFreeSpace truth(RigOf(config_));
      const torch::Tensor told = answer(batch);
      return Answered{told, FreeSpaceLabels(*batch, &truth)};
    });
    MapperSums sums;
    for (const Answered& one : all) sums.Add(one.told, one.truth, config_.obstacle_weight);
    return Measures::Of(sums.Means());
  }

  MapperTrainConfig config_;
  sim::Rng rng_;
  agent::MapperNet net_;
};

LearnerMaker MakerOf(const MapperTrainConfig& config) {
  return [config] {
    return std::make_unique<MapperLearner>(config);
  };
}

}  // namespace

MapperTraining::MapperTraining(const Config& config, const TrainContext& context)
    : MapperTraining(config, LoadBatches(config, MakerOf(config), true, context)) {}

MapperTraining::MapperTraining(const Config& config, BatchSources batches)
    : SupervisedTraining(config, MakerOf(config), std::move(batches)) {}

std::string MapperTraining::title() const {
  return "The mapper from colour";
}

std::string MapperTraining::Describe(const Measures& m) const {
  return fmt::format(
      "loss {:.3f}; explored IoU {:.3f}; obstacles IoU {:.3f}, to a cell: precision {:.3f}, "
      "recall {:.3f}; F1 to 1, 2, 3.2 m: {:.2f}, {:.2f}, {:.2f}",
      m.at("loss"), m.at("explored_iou"), m.at("obstacle_iou"), m.at("obstacle_precision"),
      m.at("obstacle_recall"), m.at("obstacle_f1_1m"), m.at("obstacle_f1_2m"),
      m.at("obstacle_f1_3m"));
}

std::string MapperTraining::curves_label() const {
  return "validation";
}

std::vector<CurveLine> MapperTraining::curves() const {
  return {{"explored, IoU", "explored_iou"},
          {"obstacles to 1 m, F1", "obstacle_f1_1m"},
          {"obstacles to 2 m, F1", "obstacle_f1_2m"},
          {"obstacles to 3.2 m, F1", "obstacle_f1_3m"}};
}

namespace {

const TrainerRegistration<MapperTraining> registration;

}  // namespace
}  // namespace bulletnav::bench
