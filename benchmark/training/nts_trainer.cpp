// SPDX-License-Identifier: MIT
#include "benchmark/training/nts_trainer.h"

#include <cmath>
#include <filesystem>

#include <fmt/core.h>

#include "agent/perception/semantic_net.h"
#include "benchmark/evaluation/folder_lock.h"
#include "benchmark/training/adam.h"
#include "benchmark/training/augment.h"
#include "benchmark/training/checkpoint.h"
#include "benchmark/training/curves.h"
#include "benchmark/training/nts_loss.h"
#include "benchmark/training/nts_metrics.h"
#include "sim/base/check.h"
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
  NtsTrainer(const TrainConfig& config, BatchSource* train, BatchSource* validation,
             TrainObserver* observer)
      : config_(config),
        train_(train),
        validation_(validation),
        observer_(observer),
        folder_(MadeFolder(config.out)),
        lock_(folder_),
        rng_(config.seed, "train_nts"),
        net_(config.model, config.seed),
        adam_(net_),
        checkpoints_(config) {}

  void Run() {
    at::set_num_threads(config_.threads);
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
  torch::Tensor Input(PairBatch& batch) const {
    const torch::Tensor color = torch::from_blob(
        batch.color.data(), {batch.count, agent::kPanoramaRows, agent::kPanoramaCols, 3},
        torch::kUInt8);
    torch::Tensor depth;
    if (config_.model.uses_depth()) {
      CHECK(!batch.depth.empty());
      depth = torch::from_blob(batch.depth.data(),
                               {batch.count, agent::kPanoramaRows, agent::kPanoramaCols},
                               torch::kFloat32);
    }
    return agent::PrepareInput(config_.model, color, depth);
  }

  static PairBatch Next(BatchSource* source, std::uint64_t number) {
    PairBatch batch = source->Batch(number);
    batch.Check();
    return batch;
  }

  /// One step of the optimiser; its loss.
  double Step() {
    const auto step = static_cast<std::uint64_t>(state_.step);
    net_.train();
    std::vector<torch::Tensor> inputs;
    std::vector<LabelledPairs> labels;
    for (int scene = 0; scene < config_.scenes; ++scene) {
      const std::uint64_t number =
          step * static_cast<std::uint64_t>(config_.scenes) + static_cast<std::uint64_t>(scene);
      PairBatch batch = Next(train_, number);
      Augment(config_.augment, rng_.Fork("augment", number), &batch);
      inputs.push_back(Input(batch));
      const auto pairs = DrawPairs(batch, config_.pairs, rng_.Fork("pairs", number));
      labels.push_back(Labels(batch, pairs));
    }
    const LabelledPairs all = Join(labels);
    const auto dropout = at::detail::createCPUGenerator(sim::MixSeed(config_.seed, step));
    const agent::PanoramaParts parts = net_.Describe(at::cat(inputs), dropout);
    const torch::Tensor total =
        Losses(parts.explorable, net_.Compare(parts.Select(all.source), parts.Select(all.goal)),
               all)
            .Total();
    const auto loss = total.item<double>();
    RequireNumber(loss, "training");
    total.backward();
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
    const torch::NoGradGuard no_grad;
    net_.eval();
    MetricSums sums;
    for (int i = 0; i < config_.validation_batches; ++i) {
      PairBatch batch = Next(validation_, static_cast<std::uint64_t>(i));
      const LabelledPairs labels = Labels(batch, AllPairs(batch));
      const agent::PanoramaParts parts = net_.Describe(Input(batch));
      sums.Add(parts.explorable,
               net_.Compare(parts.Select(labels.source), parts.Select(labels.goal)), labels);
    }
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
  BatchSource* train_;
  BatchSource* validation_;
  TrainObserver* observer_;
  fs::path folder_;
  FolderLock lock_;
  sim::Rng rng_;
  agent::SemanticNet net_;
  Adam adam_;
  Checkpoints checkpoints_;
  TrainState state_;
};

}  // namespace

void TrainNts(const TrainConfig& config, BatchSource* train, BatchSource* validation,
              TrainObserver* observer) {
  NtsTrainer(config, train, validation, observer).Run();
}

}  // namespace bulletnav::bench
