// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "benchmark/training/supervised/supervised_training.h"
#include "benchmark/training/supervised/train_config.h"

namespace bulletnav::bench {

/// The training of the mapper that agents without depth use, from panoramas with depth; see
/// MapperNet, TrueFreeSpace and LossesOf.
class MapperTraining final : public SupervisedTraining {
 public:
  static constexpr std::string_view kName = "mapper";
  using Config = MapperTrainConfig;

  MapperTraining(const Config& config, const TrainContext& context);
  MapperTraining(const Config& config, BatchSources batches);

  std::string title() const override;
  std::string Describe(const Measures& measures) const override;
  std::string curves_label() const override;
  std::vector<CurveLine> curves() const override;
};

}  // namespace bulletnav::bench
