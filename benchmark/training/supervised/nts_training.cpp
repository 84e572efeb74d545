// SPDX-License-Identifier: MIT
#include "benchmark/training/supervised/nts_training.h"

#include <utility>

#include <fmt/core.h>

#include "agent/integer/integer_model.h"
#include "agent/integer/quantised_file.h"
#include "agent/perception/quantise.h"
#include "agent/perception/semantic_net.h"
#include "benchmark/base/shipped_file.h"
#include "benchmark/training/core/registry.h"
#include "benchmark/training/supervised/answer_batches.h"
#include "benchmark/training/supervised/augment.h"
#include "benchmark/training/supervised/batch_tensors.h"
#include "benchmark/training/supervised/calibration.h"
#include "benchmark/training/supervised/learner.h"
#include "benchmark/training/supervised/model_answers.h"
#include "benchmark/training/supervised/nts_loss.h"
#include "benchmark/training/supervised/nts_metrics.h"

namespace bulletnav::bench {
namespace {

class NtsLearner final : public Learner {
 public:
  explicit NtsLearner(const TrainConfig& config)
      : config_(config), rng_(config.seed, "train_nts"), net_(config.model, config.seed) {
    if (config.start) agent::TakeNet(ShippedOr(*config.start), &net_);
  }

  torch::nn::Module& net() override { return net_; }

  torch::Tensor Loss(const LaneWork& work) override {
    std::vector<torch::Tensor> inputs;
    std::vector<LabelledPairs> labels;
    for (int i = 0; i < work.count; ++i) {
      const std::uint64_t number = work.first + static_cast<std::uint64_t>(i);
      PairBatch batch = work.batches->Batch(number);
      batch.Check();
      Augment(config_.augment, rng_.Fork("augment", number), DepthUse::kInput, &batch);
      inputs.push_back(InputOf(config_.model, &batch));
      labels.push_back(Labels(batch, DrawPairs(batch, config_.pairs, rng_.Fork("pairs", number))));
    }
    const LabelledPairs all = Join(labels);
    const agent::PanoramaParts parts = net_.Describe(at::cat(inputs).to(DeviceOf(net_)),
                                                     at::detail::createCPUGenerator(work.seed));
    return Losses(parts.explorable.cpu(), Compare(parts, all), all)
        .Total({ContrastWeight(work.step), config_.rejection.value_or(0.0)});
  }

  Measures Validate(const BatchSource& batches, int count, sim::WorkerPool* pool) override {
    return MeasuresOf(batches, count, pool, [this](PairBatch* batch, const LabelledPairs& truth) {
      const agent::PanoramaParts parts =
          net_.Describe(InputOf(config_.model, batch).to(DeviceOf(net_)));
      return ModelAnswers{parts.explorable.cpu(), Compare(parts, truth)};
    });
  }

  std::optional<Measures> Quantise(const QuantiseWork& work) override {
    if (!agent::HasIntegerForm(config_.model)) return std::nullopt;
    const agent::QuantisedNet net =
        agent::Quantise(*agent::LoadNet(work.file), CalibrationInput(*work.train, config_.model));
    agent::AddQuantised(net, work.file, work.file);
    return MeasuresOf(
        *work.validation, work.count, work.pool, [&](PairBatch* batch, const LabelledPairs& truth) {
          agent::IntegerModel model(net, config_.model.rows, config_.model.uses_depth());
          return AnswersOf(&model, *batch, truth);
        });
  }

  void Save(std::map<std::string, std::string> notes,
            const std::filesystem::path& file) const override {
    agent::SaveNet(net_, std::move(notes), agent::StoredType::kBfloat16, file);
  }

 private:
  /// Of what answer(batch, truth) gives for batches number 0 on.
  template <class F>
  static Measures MeasuresOf(const BatchSource& batches, int count, sim::WorkerPool* pool,
                             const F& answer) {
    struct Answered {
      ModelAnswers answers;
      LabelledPairs truth;
    };
    const auto all = AnswerBatches(batches, count, pool, [&](PairBatch* batch) {
      const LabelledPairs truth = Labels(*batch, AllPairs(*batch));
      return Answered{answer(batch, truth), truth};
    });
    MetricSums sums;
    for (const Answered& one : all) sums.Add(one.answers.explorable, one.answers.pairs, one.truth);
    return Measures::Of(sums.Means());
  }

  agent::PairOutputs Compare(const agent::PanoramaParts& parts, const LabelledPairs& pairs) {
    const torch::Device device = DeviceOf(net_);
    const agent::PairOutputs out =
        net_.Compare(parts.Select(pairs.source.to(device)), parts.Select(pairs.goal.to(device)));
    return {out.same_node.cpu(), out.direction.cpu(), out.distance_score.cpu(), out.scores.cpu()};
  }

  double ContrastWeight(int step) const {
    const auto& contrast = config_.score_contrast;
    return contrast && step >= contrast->from_step ? contrast->weight : 0.0;
  }

  TrainConfig config_;
  sim::Rng rng_;
  agent::SemanticNet net_;
};

LearnerMaker MakerOf(const TrainConfig& config) {
  return [config] {
    return NtsTraining::MakeLearner(config);
  };
}

}  // namespace

NtsTraining::NtsTraining(const Config& config, const TrainContext& context)
    : NtsTraining(config,
                  LoadBatches(config, MakerOf(config), config.model.uses_depth(), context)) {}

NtsTraining::NtsTraining(const Config& config, BatchSources batches)
    : SupervisedTraining(config, MakerOf(config), std::move(batches)) {}

std::unique_ptr<Learner> NtsTraining::MakeLearner(const Config& config) {
  return std::make_unique<NtsLearner>(config);
}

std::string NtsTraining::title() const {
  return "The learned functions of Neural Topological SLAM";
}

std::string NtsTraining::Describe(const Measures& m) const {
  return fmt::format(
      "loss {:.3f}; right: same node {:.1f}%, twelfth {:.1f}%, explorable {:.1f}%, best way "
      "{:.1f}%; off by {:.2f} m, score {:.3f}",
      m.at("loss"), 100.0 * m.at("connection"), 100.0 * m.at("direction"),
      100.0 * m.at("explorable"), 100.0 * m.at("score_choice"), m.at("distance_error_m"),
      m.at("score_error"));
}

std::string NtsTraining::curves_label() const {
  return "share right, validation";
}

std::vector<CurveLine> NtsTraining::curves() const {
  return {{"same node (guessing: 0.5)", "connection"},
          {"goal's twelfth (guessing: 0.08)", "direction"},
          {"explorable (guessing: 0.5)", "explorable"},
          {"best way within 1 m", "score_choice"}};
}

namespace {

const TrainerRegistration<NtsTraining> registration;

}  // namespace
}  // namespace bulletnav::bench
