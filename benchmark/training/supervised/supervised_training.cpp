// SPDX-License-Identifier: MIT
#include "benchmark/training/supervised/supervised_training.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <thread>

#include <fmt/core.h>

#include "agent/models/model_registry.h"
#include "benchmark/base/program_version.h"
#include "benchmark/base/shipped_file.h"
#include "benchmark/base/warn_line.h"
#include "benchmark/training/supervised/scene_batches.h"
#include "benchmark/training/supervised/train_lanes.h"
#include "sim/config/yaml_reader.h"

namespace bulletnav::bench {
namespace {

constexpr std::uint64_t kTrainSeed = 0;  // added to the config's
constexpr std::uint64_t kValidationSeed = 1'000'003;

std::shared_ptr<const BatchSource> Batches(const DataConfig& data, const BatchSpec& spec,
                                           const TrainContext& context) {
  const auto scenes = static_cast<int>(ScenesOf(data).size());
  const auto labelled = context.start("labelling scenes", scenes);
  std::function<void()> loaded;
  BatchesProgress progress;
  progress.on_labelled = [&](const LabelledScene& scene) {
    if (!scene.note.empty()) fmt::print(stderr, "{}\n", scene.note);
    labelled();
  };
  progress.warn = WarnLine;
  progress.on_loading = [&] {
    loaded = context.start("loading scenes", scenes);
  };
  progress.on_loaded = [&] {
    loaded();
  };
  return std::make_shared<SceneBatches>(data, spec, progress);
}

}  // namespace

BatchSources LoadBatches(const SupervisedPlan& plan, const LearnerMaker& make, bool with_depth,
                         const TrainContext& context) {
  if (plan.start) make();
  if (!plan.data) throw sim::KeyError("data", "there is no block 'data'; see configs/train");
  const DataConfig validation = ValidationData(plan);
  for (const DataConfig& data : {*plan.data, validation}) {
    MakeHousesOf(data, CommittedVersion(), 0, context.start);
  }
  const double near = plan.near_batches.value_or(0.0);
  return {
      Batches(*plan.data, {plan.panoramas, with_depth, near, plan.seed + kTrainSeed}, context),
      Batches(validation, {plan.panoramas, with_depth, 0.0, plan.seed + kValidationSeed}, context)};
}

struct SupervisedTraining::Work {
  SupervisedPlan plan;
  LearnerMaker make;
  std::int64_t frames_before = 0;  // of the weights that it goes on from
  BatchSources batches;
  sim::WorkerPool pool;
  std::unique_ptr<Learner> learner;
  std::optional<TrainLanes> lanes;  // from the first step on: then the net is on its device
};

SupervisedTraining::SupervisedTraining(const SupervisedPlan& plan, LearnerMaker make,
                                       BatchSources batches) {
  const int threads = std::min(plan.lanes, static_cast<int>(std::thread::hardware_concurrency()));
  std::unique_ptr<Learner> learner = make();
  const std::int64_t frames_before =
      plan.start ? agent::FramesTrained(ShippedOr(*plan.start)).value_or(0) : 0;
  work_.reset(new Work{plan, std::move(make), frames_before, std::move(batches),
                       sim::WorkerPool(threads), std::move(learner), std::nullopt});
}

SupervisedTraining::~SupervisedTraining() = default;

torch::nn::Module& SupervisedTraining::net() {
  return work_->learner->net();
}

double SupervisedTraining::Learn(const TrainStep& step) {
  Work& work = *work_;
  if (!work.lanes) work.lanes.emplace(work.plan, work.make, &net(), &work.pool);
  const double loss = work.lanes->Pass(*work.batches.train, step.step);
  if (std::isfinite(loss)) step.optimiser->Step(step.rate);
  return loss;
}

Measures SupervisedTraining::Validate() {
  return work_->learner->Validate(*work_->batches.validation, work_->plan.validation_batches,
                                  &work_->pool);
}

std::int64_t SupervisedTraining::FramesAfter(int steps) const {
  return std::int64_t{steps} * work_->plan.frames();
}

std::int64_t SupervisedTraining::FramesBefore() const {
  return work_->frames_before;
}

void SupervisedTraining::Save(std::map<std::string, std::string> notes,
                              const std::filesystem::path& file) const {
  work_->learner->Save(std::move(notes), file);
}

std::optional<Measures> SupervisedTraining::Quantise(const std::filesystem::path& file) {
  return work_->learner->Quantise({work_->batches.train.get(), work_->batches.validation.get(),
                                   work_->plan.validation_batches, &work_->pool, file});
}

std::vector<std::pair<std::string, std::string>> SupervisedTraining::CardRows() const {
  const SupervisedPlan& plan = work_->plan;
  const std::string data =
      plan.data ? fmt::format("{} scenes, {} points in each, drawn with seed {}",
                              ScenesOf(*plan.data).size(), plan.data->points, plan.data->seed)
                : "made up by the caller";
  return {{"data", data},
          {"a step", fmt::format("{} panoramas of {} scenes, in up to {} threads", plan.frames(),
                                 plan.scenes, plan.lanes)}};
}

std::string SupervisedTraining::validated_on() const {
  return fmt::format("{} batches of the validation scenes", work_->plan.validation_batches);
}

}  // namespace bulletnav::bench
