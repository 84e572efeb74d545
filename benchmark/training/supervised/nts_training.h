// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "benchmark/training/supervised/supervised_training.h"
#include "benchmark/training/supervised/train_config.h"

namespace bulletnav::bench {

/// The training of the learned model of Neural Topological SLAM, appendix A.
class NtsTraining final : public SupervisedTraining {
 public:
  static constexpr std::string_view kName = "nts";
  using Config = TrainConfig;

  NtsTraining(const Config& config, const TrainContext& context);
  NtsTraining(const Config& config, BatchSources batches);

  /// Always the same net.
  static std::unique_ptr<Learner> MakeLearner(const Config& config);

  std::string title() const override;
  std::string Describe(const Measures& measures) const override;
  std::string curves_label() const override;
  std::vector<CurveLine> curves() const override;
};

}  // namespace bulletnav::bench
