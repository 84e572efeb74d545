// SPDX-License-Identifier: MIT
#include "benchmark/training/core/trainer.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <thread>
#include <vector>

#include <fmt/core.h>

#include "agent/perception/one_thread.h"
#include "benchmark/training/core/adam.h"
#include "benchmark/training/core/checkpoint.h"
#include "benchmark/training/core/curves.h"
#include "benchmark/training/core/learner.h"
#include "benchmark/training/core/model_card.h"
#include "benchmark/training/core/train_lanes.h"
#include "benchmark/training/core/train_task.h"
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

class Trainer {
 public:
  Trainer(const TrainTask& task, TrainObserver* observer)
      : task_(task),
        plan_(task_.plan),
        observer_(observer),
        folder_(MadeFolder(plan_.out)),
        lock_(folder_),
        pool_(std::min(plan_.lanes, static_cast<int>(std::thread::hardware_concurrency()))),
        learner_(task_.make()),
        lanes_(task_, &learner_->net(), &pool_),
        adam_(learner_->net()),
        checkpoints_(plan_.out, task_.essence) {}

  void Run() {
    agent::StayInThisThread();
    const std::optional<TrainState> found = checkpoints_.Read(&learner_->net(), &adam_);
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
      checkpoints_.Write(state_, learner_->net(), adam_);
      loss_sum = 0.0;
      since = 0;
    }
    Save("weights.safetensors");
    learner_->net().eval();
    const Measures measures = learner_->Validate(&pool_);
    sim::WriteFileAtomically(folder_ / "weights.md",
                             ModelCard(task_, state_.step, state_.seconds, measures));
    WriteFigure(CurvesFigure(curves.points(), task_.curves, task_.curves_label),
                folder_ / "curves");
  }

 private:
  /// One step of the optimiser; its loss.
  double Step() {
    const double loss = lanes_.Pass(state_.step);
    RequireNumber(loss, "training", state_.step + 1);
    adam_.Step(plan_.optimiser.RateAt(state_.step, plan_.steps), plan_.optimiser.weight_decay);
    ++state_.step;
    observer_->Stepped(state_.step, loss);
    return loss;
  }

  CurvePoint Validated(double train_loss) {
    CurvePoint point;
    point.step = state_.step;
    point.rate = plan_.optimiser.RateAt(state_.step - 1, plan_.steps);
    point.train_loss = train_loss;
    learner_->net().eval();
    point.validation = learner_->Validate(&pool_);
    const double loss = point.validation.at("loss");
    RequireNumber(loss, "validation", state_.step);
    if (loss < state_.best_loss) {
      state_.best_loss = loss;
      Save("weights_best.safetensors");
    }
    observer_->Validated(state_.step, point.validation, task_.describe(point.validation));
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
    learner_->Save({{"task", task_.name},
                    {"training", task_.config},
                    {"step", std::to_string(state_.step)},
                    {"frames", std::to_string(state_.step * task_.frames)}},
                   folder_ / name);
  }

  TrainTask task_;
  const TrainPlan& plan_;
  TrainObserver* observer_;
  fs::path folder_;
  sim::FolderLock lock_;
  sim::WorkerPool pool_;
  std::unique_ptr<Learner> learner_;
  TrainLanes lanes_;
  Adam adam_;
  Checkpoints checkpoints_;
  TrainState state_;
};

}  // namespace

void RunTraining(const TrainTask& task, TrainObserver* observer) {
  Trainer(task, observer).Run();
}

}  // namespace bulletnav::bench
