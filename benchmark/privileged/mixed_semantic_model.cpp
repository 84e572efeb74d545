// SPDX-License-Identifier: MIT
#include "benchmark/privileged/mixed_semantic_model.h"

#include "sim/base/check.h"

namespace bulletnav::bench {
namespace {

using agent::PairPrediction;
using agent::PanoramaCode;

constexpr float kSurely = 0.5f;  // the oracle says 0 or 1

PairPrediction CompareOne(agent::SemanticModel* model, const PanoramaCode& source,
                          const PanoramaCode& goal) {
  const std::array<const PanoramaCode*, 1> sources = {&source};
  return model->Compare(sources, goal).front();
}

}  // namespace

MixedSemanticModel::MixedSemanticModel(std::shared_ptr<agent::SemanticModel> model,
                                       std::shared_ptr<agent::SemanticModel> oracle,
                                       std::set<SemanticFunction> from_oracle)
    : model_(std::move(model)), oracle_(std::move(oracle)), from_oracle_(std::move(from_oracle)) {}

std::vector<PanoramaCode> MixedSemanticModel::Encode(std::span<const agent::Panorama> panoramas) {
  std::vector<PanoramaCode> codes = model_->Encode(panoramas);
  const std::vector<PanoramaCode> more = oracle_->Encode(panoramas);
  for (std::size_t i = 0; i < codes.size(); ++i) {
    codes[i].insert(codes[i].end(), more[i].begin(), more[i].end());
    oracle_size_ = more[i].size();
  }
  return codes;
}

std::array<float, agent::kDirections> MixedSemanticModel::Explorable(const PanoramaCode& source) {
  const Codes codes = Split(source);
  return from_oracle_.contains(SemanticFunction::kExplorable) ? oracle_->Explorable(codes.oracle)
                                                              : model_->Explorable(codes.model);
}

std::vector<PairPrediction> MixedSemanticModel::Compare(
    std::span<const PanoramaCode* const> sources, const PanoramaCode& goal) {
  const Codes goal_codes = Split(goal);
  std::vector<PairPrediction> predictions;
  for (const PanoramaCode* source : sources) {
    predictions.push_back(ComparePair(Split(*source), goal_codes));
  }
  return predictions;
}

MixedSemanticModel::Codes MixedSemanticModel::Split(const PanoramaCode& code) const {
  BULLETNAV_CHECK_LE(oracle_size_, code.size());
  const auto middle = code.end() - static_cast<std::ptrdiff_t>(oracle_size_);
  return {PanoramaCode(code.begin(), middle), PanoramaCode(middle, code.end())};
}

PairPrediction MixedSemanticModel::ComparePair(const Codes& source, const Codes& goal) {
  PairPrediction prediction = CompareOne(model_.get(), source.model, goal.model);
  const PairPrediction truth = CompareOne(oracle_.get(), source.oracle, goal.oracle);
  const bool is_near = truth.same_node > kSurely;
  if (from_oracle_.contains(SemanticFunction::kConnection)) prediction.same_node = truth.same_node;
  if (from_oracle_.contains(SemanticFunction::kPose) && is_near) {
    prediction.direction = truth.direction;
    prediction.distance = truth.distance;
  }
  if (from_oracle_.contains(SemanticFunction::kScores) && !is_near) prediction.score = truth.score;
  return prediction;
}

}  // namespace bulletnav::bench
