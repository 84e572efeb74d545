// SPDX-License-Identifier: MIT
#include "benchmark/training/nts_trainer.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <thread>
#include <vector>

#include <fmt/core.h>

#include "agent/perception/one_thread.h"
#include "agent/perception/semantic_net.h"
#include "benchmark/evaluation/folder_lock.h"
#include "benchmark/training/adam.h"
#include "benchmark/training/checkpoint.h"
#include "benchmark/training/curves.h"
#include "benchmark/training/nts_metrics.h"
#include "benchmark/training/train_lanes.h"
#include "sim/base/error.h"
#include "sim/base/files.h"
#include "sim/config/yaml_writer.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;

std::filesystem::path MadeFolder(const fs::path& folder) {
  sim::MakeFolder(folder);
  return folder;
}

class NtsTrainer {
 public:
  NtsTrainer(const TrainConfig& config, const BatchSource* train, const BatchSource* validation,
             TrainObserver* observer)
      : config_(config),
        train_(train),
        validation_(validation),
        observer_(observer),
        folder_(MadeFolder(config.out)),
        lock_(folder_),
        pool_(std::min(config.lanes, static_cast<int>(std::thread::hardware_concurrency()))),
        net_(config.model, config.seed),
        lanes_(config_, &net_, &pool_),
        adam_(net_),
        checkpoints_(config) {}

  void Run() {
    agent::StayInThisThread();
    const std::optional<TrainState> found = checkpoints_.Read(&net_, &adam_);
    if (found) state_ = *found;
    if (state_.step > 0) observer_->Resumed(state_.step);
    Curves curves(folder_ / "curves.csv", state_.step);
    double loss_sum = 0.0;
    int since = 0;
    while (state_.step < config_.steps) {
      loss_sum += Step();
      ++since;
      if (state_.step % config_.validate_every != 0 && state_.step < config_.steps) continue;
      curves.Append(Validated(loss_sum / since));
      checkpoints_.Write(state_, net_, adam_);
      loss_sum = 0.0;
      since = 0;
    }
    Save("weights.safetensors");
    WriteFigure(CurvesFigure(curves.points()), folder_ / "curves");
  }

 private:
  /// One step of the optimiser; its loss.
  double Step() {
    const double loss = lanes_.Pass(*train_, state_.step);
    RequireNumber(loss, "training");
    adam_.Step(config_.optimiser.RateAt(state_.step, config_.steps),
               config_.optimiser.weight_decay);
    ++state_.step;
    observer_->Stepped(state_.step, loss);
    return loss;
  }

  CurvePoint Validated(double train_loss) {
    CurvePoint point;
    point.step = state_.step;
    point.rate = config_.optimiser.RateAt(state_.step - 1, config_.steps);
    point.train_loss = train_loss;
    point.validation = Validate();
    const double loss = point.validation.loss;
    RequireNumber(loss, "validation");
    if (loss < state_.best_loss) {
      state_.best_loss = loss;
      Save("weights_best.safetensors");
    }
    observer_->Validated(state_.step, point.validation);
    return point;
  }

  NtsMetrics Validate() {
    struct Answers {
      torch::Tensor explorable;
      agent::PairOutputs pairs;
      LabelledPairs truth;
    };
    std::vector<Answers> answers(static_cast<std::size_t>(config_.validation_batches));
    net_.eval();
    pool_.ForEach(config_.validation_batches, [&](int i, int) {
      const torch::NoGradGuard no_grad;
      agent::StayInThisThread();
      PairBatch batch = validation_->Batch(static_cast<std::uint64_t>(i));
      batch.Check();
      const LabelledPairs truth = Labels(batch, AllPairs(batch));
      const agent::PanoramaParts parts = net_.Describe(InputOf(config_.model, &batch));
      answers[static_cast<std::size_t>(i)] = {
          parts.explorable, net_.Compare(parts.Select(truth.source), parts.Select(truth.goal)),
          truth};
    });
    MetricSums sums;
    for (const Answers& one : answers) sums.Add(one.explorable, one.pairs, one.truth);
    return sums.Means();
  }

  void RequireNumber(double loss, const std::string& which) const {
    if (std::isfinite(loss)) return;
    const std::string kept = fs::exists(checkpoints_.newest())
                                 ? "the last good checkpoint is " + checkpoints_.newest().string()
                                 : "there is no checkpoint yet";
    throw sim::Error(fmt::format("the {} loss is {} at step {}; {}; lower the learning_rate", which,
                                 loss, state_.step + 1, kept));
  }

  void Save(const std::string& name) const {
    agent::SaveNet(net_,
                   {{"training", sim::ToYaml(config_)}, {"step", std::to_string(state_.step)}},
                   agent::StoredType::kFloat32, folder_ / name);
  }

  TrainConfig config_;
  const BatchSource* train_;
  const BatchSource* validation_;
  TrainObserver* observer_;
  fs::path folder_;
  FolderLock lock_;
  sim::WorkerPool pool_;
  agent::SemanticNet net_;
  TrainLanes lanes_;
  Adam adam_;
  Checkpoints checkpoints_;
  TrainState state_;
};

}  // namespace

void TrainNts(const TrainConfig& config, const BatchSource& train, const BatchSource& validation,
              TrainObserver* observer) {
  NtsTrainer(config, &train, &validation, observer).Run();
}

}  // namespace bulletnav::bench
