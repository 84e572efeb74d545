// SPDX-License-Identifier: MIT
#include "benchmark/training/supervised/nts_trainer.h"

#include <utility>

#include <fmt/core.h>

#include "agent/perception/one_thread.h"
#include "agent/perception/semantic_net.h"
#include "benchmark/training/core/learner.h"
#include "benchmark/training/supervised/augment.h"
#include "benchmark/training/supervised/batch_tensors.h"
#include "benchmark/training/supervised/nts_loss.h"
#include "benchmark/training/supervised/nts_metrics.h"

namespace bulletnav::bench {
namespace {

class NtsLearner final : public Learner {
 public:
  NtsLearner(const TrainConfig& config, SupervisedData data)
      : config_(config),
        data_(std::move(data)),
        rng_(config.seed, "train_nts"),
        net_(config.model, config.seed) {}

  torch::nn::Module& net() override { return net_; }

  torch::Tensor Loss(const LaneWork& work) override {
    std::vector<torch::Tensor> inputs;
    std::vector<LabelledPairs> labels;
    for (int i = 0; i < work.count; ++i) {
      const std::uint64_t number = work.first + static_cast<std::uint64_t>(i);
      PairBatch batch = data_.train.Batch(number);
      batch.Check();
      Augment(config_.augment, rng_.Fork("augment", number), &batch);
      inputs.push_back(InputOf(config_.model, &batch));
      labels.push_back(Labels(batch, DrawPairs(batch, config_.pairs, rng_.Fork("pairs", number))));
    }
    const LabelledPairs all = Join(labels);
    const agent::PanoramaParts parts =
        net_.Describe(at::cat(inputs), at::detail::createCPUGenerator(work.seed));
    return Losses(parts.explorable, net_.Compare(parts.Select(all.source), parts.Select(all.goal)),
                  all)
        .Total({ContrastWeight(work.step), config_.rejection.value_or(0.0)});
  }

  Measures Validate(sim::WorkerPool* pool) override {
    const int count = config_.validation_batches;
    struct Answers {
      torch::Tensor explorable;
      agent::PairOutputs pairs;
      LabelledPairs truth;
    };
    std::vector<Answers> answers(static_cast<std::size_t>(count));
    pool->ForEach(count, [&](int i, int) {
      const torch::NoGradGuard no_grad;
      agent::StayInThisThread();
      PairBatch batch = data_.validation.Batch(static_cast<std::uint64_t>(i));
      batch.Check();
      const LabelledPairs truth = Labels(batch, AllPairs(batch));
      const agent::PanoramaParts parts = net_.Describe(InputOf(config_.model, &batch));
      answers[static_cast<std::size_t>(i)] = {
          parts.explorable, net_.Compare(parts.Select(truth.source), parts.Select(truth.goal)),
          truth};
    });
    MetricSums sums;
    for (const Answers& one : answers) sums.Add(one.explorable, one.pairs, one.truth);
    return Measures::Of(sums.Means());
  }

  void Save(std::map<std::string, std::string> notes,
            const std::filesystem::path& file) const override {
    agent::SaveNet(net_, std::move(notes), agent::StoredType::kBfloat16, file);
  }

 private:
  double ContrastWeight(int step) const {
    const auto& contrast = config_.score_contrast;
    return contrast && step >= contrast->from_step ? contrast->weight : 0.0;
  }

  TrainConfig config_;
  SupervisedData data_;
  sim::Rng rng_;
  agent::SemanticNet net_;
};

std::string Describe(const Measures& m) {
  return fmt::format(
      "loss {:.3f}; right: same node {:.1f}%, twelfth {:.1f}%, explorable {:.1f}%, best way "
      "{:.1f}%; off by {:.2f} m, score {:.3f}",
      m.at("loss"), 100.0 * m.at("connection"), 100.0 * m.at("direction"),
      100.0 * m.at("explorable"), 100.0 * m.at("score_choice"), m.at("distance_error_m"),
      m.at("score_error"));
}

}  // namespace

TrainTask NtsTask(const TrainConfig& config, const SupervisedData& data) {
  TrainTask task = SupervisedTask(config);
  task.name = "nts";
  task.make = [config, data] {
    return std::make_unique<NtsLearner>(config, data);
  };
  task.title = "The learned functions of Neural Topological SLAM";
  task.describe = Describe;
  task.curves_label = "share right, validation";
  task.curves = {{"same node (guessing: 0.5)", "connection"},
                 {"goal's twelfth (guessing: 0.08)", "direction"},
                 {"explorable (guessing: 0.5)", "explorable"},
                 {"best way within 1 m", "score_choice"}};
  return task;
}

namespace {

struct NtsTrainer {
  static constexpr std::string_view kName = "nts";
  using Config = TrainConfig;
  static TrainTask Prepare(const Config& config, const TrainerContext& context) {
    return NtsTask(config, LoadSupervisedData(config, config.model.uses_depth(), context));
  }
};

const TrainerRegistration<NtsTrainer> registration;

}  // namespace

}  // namespace bulletnav::bench
