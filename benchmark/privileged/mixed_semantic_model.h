// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include "agent/models/semantic_model.h"
#include "sim/config/enum_names.h"

namespace bulletnav::bench {

/// The functions of Neural Topological SLAM, section 4: F_L, F_R, F_G and F_S.
enum class SemanticFunction { kConnection, kPose, kExplorable, kScores };

}  // namespace bulletnav::bench

template <>
struct bulletnav::sim::EnumNames<bulletnav::bench::SemanticFunction> {
  static constexpr std::array kNames = {
      std::pair{"connection", bulletnav::bench::SemanticFunction::kConnection},
      std::pair{"pose", bulletnav::bench::SemanticFunction::kPose},
      std::pair{"explorable", bulletnav::bench::SemanticFunction::kExplorable},
      std::pair{"scores", bulletnav::bench::SemanticFunction::kScores}};
};

namespace bulletnav::bench {

/// Takes some functions from an oracle and the others from a model, to find out which of them costs
/// an agent its success. A code is the model's followed by the oracle's.
/// Where the oracle is silent because it knows better - it has no pose of a goal of another node,
/// no scores of one of the same - the model's answer stands.
class MixedSemanticModel final : public agent::SemanticModel {
 public:
  MixedSemanticModel(std::shared_ptr<agent::SemanticModel> model,
                     std::shared_ptr<agent::SemanticModel> oracle,
                     std::set<SemanticFunction> from_oracle);

  std::vector<agent::PanoramaCode> Encode(std::span<const agent::Panorama> panoramas) override;
  std::array<float, agent::kDirections> Explorable(const agent::PanoramaCode& source) override;
  std::vector<agent::PairPrediction> Compare(std::span<const agent::PanoramaCode* const> sources,
                                             const agent::PanoramaCode& goal) override;

 private:
  struct Codes {
    agent::PanoramaCode model;
    agent::PanoramaCode oracle;
  };
  Codes Split(const agent::PanoramaCode& code) const;
  agent::PairPrediction ComparePair(const Codes& source, const Codes& goal);

  std::shared_ptr<agent::SemanticModel> model_;
  std::shared_ptr<agent::SemanticModel> oracle_;
  std::set<SemanticFunction> from_oracle_;
  std::size_t oracle_size_ = 0;  // of its codes
};

}  // namespace bulletnav::bench
