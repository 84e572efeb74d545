// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "benchmark/training/core/registry.h"
#include "benchmark/training/core/training.h"
#include "benchmark/training/supervised/learner.h"
#include "benchmark/training/supervised/pair_batch.h"
#include "benchmark/training/supervised/train_config.h"

namespace bulletnav::bench {

/// What a training learns from and what it is tried on.
struct BatchSources {
  std::shared_ptr<const BatchSource> train;
  std::shared_ptr<const BatchSource> validation;  // batches number 0 on
};

/// Makes and labels what the plan's data lack, and loads it. If the plan starts from weights,
/// `make` is tried first: bad ones are better told of before minutes of work. Throws Error, also if
/// there is no block `data`; see SceneBatches.
BatchSources LoadBatches(const SupervisedPlan& plan, const LearnerMaker& make, bool with_depth,
                         const TrainContext& context);

/// A training of a Learner from batches, in lanes; the same bits on any number of threads.
class SupervisedTraining : public Training {
 public:
  SupervisedTraining(const SupervisedPlan& plan, LearnerMaker make, BatchSources batches);
  ~SupervisedTraining() override;
  SupervisedTraining(const SupervisedTraining&) = delete;
  SupervisedTraining& operator=(const SupervisedTraining&) = delete;
  SupervisedTraining(SupervisedTraining&&) = delete;
  SupervisedTraining& operator=(SupervisedTraining&&) = delete;

  torch::nn::Module& net() override;
  double Learn(const TrainStep& step) override;
  Measures Validate() override;
  std::int64_t FramesAfter(int steps) const override;
  std::int64_t FramesBefore() const override;
  std::string frames_are() const override { return "panoramas"; }
  void Save(std::map<std::string, std::string> notes,
            const std::filesystem::path& file) const override;
  std::optional<Measures> Quantise(const std::filesystem::path& file) override;
  std::vector<std::pair<std::string, std::string>> CardRows() const override;
  std::string validated_on() const override;

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

}  // namespace bulletnav::bench
