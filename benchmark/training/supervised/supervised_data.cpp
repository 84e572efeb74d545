// SPDX-License-Identifier: MIT
#include "benchmark/training/supervised/supervised_data.h"

#include <functional>

#include <fmt/core.h>

#include "benchmark/base/program_version.h"
#include "benchmark/training/supervised/scene_batches.h"

namespace bulletnav::bench {
namespace {

constexpr std::uint64_t kTrainSeed = 0;  // added to the config's
constexpr std::uint64_t kValidationSeed = 1'000'003;

struct Loaded {
  SceneBatches train;
  SceneBatches validation;
};

SceneBatches Load(const SupervisedPlan& plan, const DataConfig& data, const BatchSpec& spec,
                  const TrainerContext& context) {
  const auto scenes = static_cast<int>(ScenesOf(data).size());
  const auto labelled = context.start("labelling scenes", scenes);
  std::function<void()> loaded;
  BatchesProgress progress;
  progress.on_labelled = [&](const LabelledScene& scene) {
    if (!scene.note.empty() && context.log != nullptr) *context.log << scene.note << "\n";
    labelled();
  };
  progress.on_loading = [&] {
    loaded = context.start("loading scenes", scenes);
  };
  progress.on_loaded = [&] {
    loaded();
  };
  return {
      data, {plan.panoramas, spec.with_depth, spec.near_batches, plan.seed + spec.seed}, progress};
}

}  // namespace

SupervisedData LoadSupervisedData(const SupervisedPlan& plan, bool with_depth,
                                  const TrainerContext& context) {
  if (!plan.data) {
    throw sim::KeyError("data", "there is no block 'data'; see configs/train");
  }
  for (const DataConfig& data : {*plan.data, ValidationData(plan)}) {
    MakeHousesOf(data, CommittedVersion(), 0, context.start);
  }
  const BatchSpec train = {0, with_depth, plan.near_batches.value_or(0.0), kTrainSeed};
  const BatchSpec validation = {0, with_depth, 0.0, kValidationSeed};
  const std::shared_ptr<const Loaded> loaded(
      new Loaded{Load(plan, *plan.data, train, context),
                 Load(plan, ValidationData(plan), validation, context)});
  return {loaded->train, loaded->validation, loaded};
}

void DescribeData(const SupervisedPlan& plan, TrainTask* task) {
  task->batches = plan.scenes;
  task->frames = plan.scenes * plan.panoramas;
  task->frames_are = "panoramas";
  task->data = plan.data
                   ? fmt::format("{} scenes, {} points in each, drawn with seed {}",
                                 ScenesOf(*plan.data).size(), plan.data->points, plan.data->seed)
                   : "made up by the caller";
  task->validation = fmt::format("{} batches of the validation scenes", plan.validation_batches);
}

}  // namespace bulletnav::bench
