// SPDX-License-Identifier: MIT
#include "benchmark/training/core/trainer.h"

#include <chrono>
#include <cmath>
#include <filesystem>
#include <optional>

#include <fmt/core.h>

#include "agent/perception/one_thread.h"
#include "agent/perception/torch.h"
#include "benchmark/training/core/adam.h"
#include "benchmark/training/core/checkpoint.h"
#include "benchmark/training/core/curves.h"
#include "benchmark/training/core/model_card.h"
#include "sim/base/error.h"
#include "sim/base/files.h"
#include "sim/base/folder_lock.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

std::filesystem::path MadeFolder(const fs::path& folder) {
  sim::MakeFolder(folder);
  return folder;
}

/// On the plan's device before an optimiser takes hold of its parameters.
std::unique_ptr<Optimiser> OptimiserOf(const TrainJob& job) {
  torch::nn::Module& net = job.training->net();
  if (job.plan.device == Device::kCuda) net.to(torch::kCUDA);
  std::unique_ptr<Optimiser> own = job.training->MakeOptimiser();
  return own ? std::move(own) : std::make_unique<Adam>(net, job.plan.optimiser.weight_decay);
}

class Trainer {
 public:
  Trainer(const TrainJob& job, TrainObserver* observer)
      : job_(job),
        plan_(job.plan),
        training_(job.training.get()),
        observer_(observer),
        folder_(MadeFolder(plan_.out)),
        lock_(folder_),
        optimiser_(OptimiserOf(job)),
        checkpoints_(plan_.out, job.essence) {}

  void Run() {
    agent::StayInThisThread();
    const std::optional<TrainState> found = checkpoints_.Read(training_, optimiser_.get());
    if (found) state_ = *found;
    if (state_.step > 0) observer_->Resumed(state_.step);
    Curves curves(folder_ / "curves.csv", state_.step);
    const Clock::time_point start = Clock::now();
    const double before = state_.seconds;
    double loss_sum = 0.0;
    int since = 0;
    while (state_.step < plan_.steps) {
      loss_sum += Step();
      ++since;
      if (state_.step % plan_.validate_every != 0 && state_.step < plan_.steps) continue;
      state_.seconds = before + std::chrono::duration<double>(Clock::now() - start).count();
      curves.Append(Validated(loss_sum / since));
      checkpoints_.Write(state_, training_, *optimiser_);
      loss_sum = 0.0;
      since = 0;
    }
    Finish(curves);
  }

 private:
  void Finish(const Curves& curves) const {
    Save("weights.safetensors");
    training_->net().eval();
    const Measures floats = training_->Validate();
    const std::optional<Measures> integers = training_->Quantise(folder_ / "weights.safetensors");
    sim::WriteFileAtomically(folder_ / "weights.md",
                             ModelCard(job_, state_.step, state_.seconds, {floats, integers}));
    WriteFigure(CurvesFigure(curves.points(), training_->curves(), training_->curves_label()),
                folder_ / "curves");
  }

  double Step() {
    training_->net().train();
    const double rate = plan_.optimiser.RateAt(state_.step, plan_.steps);
    const double loss = training_->Learn({state_.step, rate, optimiser_.get()});
    RequireNumber(loss, "training", state_.step + 1);
    ++state_.step;
    observer_->Stepped(state_.step, loss);
    return loss;
  }

  CurvePoint Validated(double train_loss) {
    CurvePoint point;
    point.step = state_.step;
    point.rate = plan_.optimiser.RateAt(state_.step - 1, plan_.steps);
    point.train_loss = train_loss;
    training_->net().eval();
    point.validation = training_->Validate();
    const double loss = point.validation.at("loss");
    RequireNumber(loss, "validation", state_.step);
    if (loss < state_.best_loss) {
      state_.best_loss = loss;
      Save("weights_best.safetensors");
    }
    observer_->Validated(state_.step, point.validation, training_->Describe(point.validation));
    return point;
  }

  void RequireNumber(double loss, const std::string& which, std::int64_t step) const {
    if (std::isfinite(loss)) return;
    const std::string kept = fs::exists(checkpoints_.newest())
                                 ? "the last good checkpoint is " + checkpoints_.newest().string()
                                 : "there is no checkpoint yet";
    throw sim::Error(fmt::format(
        "the {} loss is {} at step {}; {}; lower the learning_rate and train in another "
        "folder (out)",
        which, loss, step, kept));
  }

  void Save(const std::string& name) const {
    training_->Save({{"training", job_.config},
                     {"task", job_.task},
                     {"step", std::to_string(state_.step)},
                     {"frames", std::to_string(training_->FramesAfter(state_.step))}},
                    folder_ / name);
  }

  const TrainJob& job_;
  const TrainPlan& plan_;
  Training* training_;
  TrainObserver* observer_;
  fs::path folder_;
  sim::FolderLock lock_;
  std::unique_ptr<Optimiser> optimiser_;
  Checkpoints checkpoints_;
  TrainState state_;
};

}  // namespace

void RunTraining(const TrainJob& job, TrainObserver* observer) {
  RequireDevice(job.plan);
  Trainer(job, observer).Run();
}

void RequireDevice(const TrainPlan& plan) {
  if (plan.device == Device::kCuda && !at::hasCUDA()) {
    throw sim::KeyError("device",
                        "device is cuda, but torch finds none here; train with device: cpu");
  }
}

}  // namespace bulletnav::bench
