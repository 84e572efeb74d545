// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <memory>

#include "agent/models/semantic_model.h"
#include "agent/perception/model_config.h"

namespace bulletnav::agent {

/// A SemanticModel with weights learned in the simulator. One per thread. All work is done in the
/// calling thread, one panorama and one pair after the other, so that answers are the same, bit
/// for bit, whatever else is asked and however many threads there are.
class LearnedModel : public SemanticModel {
 public:
  /// Throws FileError if the weights cannot be used, Error if `rig` does not give what they take:
  /// 128 x 512 panoramas with colour and, by their configuration, depth.
  LearnedModel(const std::filesystem::path& weights, const Rig& rig);
  ~LearnedModel() override;

  const ModelConfig& config() const;

  /// Expects: panoramas as the rig said (checked).
  std::vector<PanoramaCode> Encode(std::span<const Panorama> panoramas) override;
  std::array<float, kDirections> Explorable(const PanoramaCode& source) override;
  std::vector<PairPrediction> Compare(std::span<const PanoramaCode* const> sources,
                                      const PanoramaCode& goal) override;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;  // keeps torch out of this header
};

}  // namespace bulletnav::agent
