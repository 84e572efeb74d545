// SPDX-License-Identifier: MIT
#include "benchmark/training/core/trainer.h"

#include <chrono>
#include <cmath>
#include <filesystem>
#include <optional>
#include <span>

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
  return own ? std::move(own) : std::make_unique<Adam>(net, job.plan.optimiser);
}

class Trainer {
 public:
  Trainer(const TrainJob& job, TrainObserver* observer, Peers* peers)
      : job_(job),
        plan_(job.plan),
        training_(job.training.get()),
        observer_(observer),
        peers_(peers),
        folder_(plan_.out) {
    if (peers_->is_first()) lock_.emplace(MadeFolder(folder_));
    optimiser_ = OptimiserOf(job);
    checkpoints_.emplace(folder_, job.essence, peers_);
  }

  void Run() {
    agent::StayInThisThread();
    const std::optional<TrainState> found = checkpoints_->Read(training_, optimiser_.get());
    if (found) state_ = *found;
    RequireNotBeyond();
    if (state_.step > 0) observer_->Resumed(state_.step);
    std::optional<Curves> curves;
    if (peers_->is_first()) curves.emplace(folder_ / "curves.csv", state_.step);
    const Clock::time_point start = Clock::now();
    const double before = state_.seconds;
    double loss_sum = 0.0;
    int since = 0;
    while (state_.step < plan_.steps) {
      loss_sum += Step();
      ++since;
      if (state_.step % plan_.validate_every != 0 && state_.step < plan_.steps) continue;
      state_.seconds = before + std::chrono::duration<double>(Clock::now() - start).count();
      const CurvePoint point = Validated(loss_sum / since);
      if (curves) curves->Append(point);
      checkpoints_->Write(state_, training_, *optimiser_);
      loss_sum = 0.0;
      since = 0;
    }
    Finish(curves);
    const double is_done = 1.0;
    peers_->Gather(std::span(&is_done, 1));  // nobody leaves before all are here
  }

 private:
  void Finish(const std::optional<Curves>& curves) const {
    Save("weights.safetensors");
    training_->net().eval();
    observer_->Validating(state_.step, "the weights");
    const Measures floats = training_->Validate();
    observer_->Validating(state_.step, "the weights in integers");
    const std::optional<Measures> integers = training_->Quantise(folder_ / "weights.safetensors");
    if (!peers_->is_first()) return;
    sim::WriteFileAtomically(folder_ / "weights.md",
                             ModelCard(job_, state_.step, state_.seconds, {floats, integers}));
    WriteFigure(CurvesFigure(curves->points(), training_->curves(), training_->curves_label()),
                folder_ / "curves");
  }

  double RateAt(int step) const {
    return training_->RateAt(step).value_or(plan_.optimiser.RateAt(step, plan_.steps));
  }

  double Step() {
    training_->net().train();
    const double loss = training_->Learn({state_.step, RateAt(state_.step), optimiser_.get()});
    RequireNumber(loss, "training", state_.step + 1);
    ++state_.step;
    observer_->Stepped(state_.step, loss);
    return loss;
  }

  CurvePoint Validated(double train_loss) {
    CurvePoint point;
    point.step = state_.step;
    point.rate = RateAt(state_.step - 1);
    point.train_loss = train_loss;
    training_->net().eval();
    observer_->Validating(state_.step, "the net");
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

  void RequireNotBeyond() const {
    if (state_.step <= plan_.steps) return;
    throw sim::Error(
        fmt::format("{}: is of step {}, beyond steps: {}; give as many or more, or change out",
                    checkpoints_->newest().string(), state_.step, plan_.steps));
  }

  void RequireNumber(double loss, const std::string& which, std::int64_t step) const {
    if (std::isfinite(loss)) return;
    const std::string kept = fs::exists(checkpoints_->newest())
                                 ? "the last good checkpoint is " + checkpoints_->newest().string()
                                 : "there is no checkpoint yet";
    throw sim::Error(fmt::format(
        "the {} loss is {} at step {}; {}; lower the learning_rate and train in another "
        "folder (out)",
        which, loss, step, kept));
  }

  void Save(const std::string& name) const {
    if (!peers_->is_first()) return;
    training_->Save({{"training", job_.config},
                     {"task", job_.task},
                     {"step", std::to_string(state_.step)},
                     {"frames", std::to_string(training_->FramesBefore() +
                                               training_->FramesAfter(state_.step))}},
                    folder_ / name);
  }

  const TrainJob& job_;
  const TrainPlan& plan_;
  Training* training_;
  TrainObserver* observer_;
  Peers* peers_;
  fs::path folder_;
  std::optional<sim::FolderLock> lock_;  // of the first process
  std::unique_ptr<Optimiser> optimiser_;
  std::optional<Checkpoints> checkpoints_;
  TrainState state_;
};

}  // namespace

void RunTraining(const TrainJob& job, TrainObserver* observer, Peers* peers) {
  RequireDevice(job.plan, job.heeds_device);
  Peers alone;
  if (peers == nullptr) peers = &alone;
  if (peers->size() > 1) {
    if (!job.training->shares_work()) {
      throw sim::Error(fmt::format(
          "task {} cannot be shared by {} processes; start one, without RANK and WORLD_SIZE",
          job.task, peers->size()));
    }
    peers->RequireSame(job.essence, "config");
  }
  Trainer(job, observer, peers).Run();
}

void RequireDevice(const TrainPlan& plan, bool heeds_device) {
  if (plan.device == Device::kCuda && !heeds_device) {
    throw sim::KeyError("device",
                        "device is cuda, but this task is trained on processors alone so far; "
                        "train with device: cpu");
  }
  if (plan.device == Device::kCuda && !at::hasCUDA()) {
    throw sim::KeyError("device",
                        "device is cuda, but torch finds none here; train with device: cpu");
  }
}

}  // namespace bulletnav::bench
