// SPDX-License-Identifier: MIT
#include "benchmark/privileged/mixed_semantic_model.h"

#include <gtest/gtest.h>

namespace bulletnav::bench {
namespace {

using agent::PairPrediction;
using agent::PanoramaCode;

/// Answers with one number everywhere, if asked with its own codes.
class Constant final : public agent::SemanticModel {
 public:
  Constant(float answer, float same_node, std::size_t code_size)
      : answer_(answer), same_node_(same_node), code_(code_size, answer) {}

  std::vector<PanoramaCode> Encode(std::span<const agent::Panorama> panoramas) override {
    return std::vector<PanoramaCode>(panoramas.size(), code_);
  }
  std::array<float, agent::kDirections> Explorable(const PanoramaCode& source) override {
    EXPECT_EQ(source, code_);
    return {answer_};
  }
  std::vector<PairPrediction> Compare(std::span<const PanoramaCode* const> sources,
                                      const PanoramaCode& goal) override {
    EXPECT_EQ(goal, code_);
    EXPECT_EQ(*sources[0], code_);
    return {{same_node_, {answer_}, answer_, {answer_}}};
  }

 private:
  float answer_;
  float same_node_;
  PanoramaCode code_;
};

PairPrediction Mix(const std::set<SemanticFunction>& functions, float truth) {
  MixedSemanticModel model(std::make_shared<Constant>(0.3f, 0.4f, 5),
                           std::make_shared<Constant>(0.7f, truth, 2), functions);
  const agent::Panorama panorama;
  const PanoramaCode code = model.Encode({&panorama, 1}).front();
  EXPECT_EQ(code.size(), 7u);
  const bool from_oracle = functions.contains(SemanticFunction::kExplorable);
  EXPECT_EQ(model.Explorable(code)[0], from_oracle ? 0.7f : 0.3f);
  const std::array<const PanoramaCode*, 1> sources = {&code};
  return model.Compare(sources, code).front();
}

TEST(MixedSemanticModel, TakesEachFunctionFromWhereItIsToldTo) {
  const PairPrediction near = Mix({SemanticFunction::kConnection, SemanticFunction::kPose}, 1.0f);
  EXPECT_EQ(near.same_node, 1.0f);
  EXPECT_EQ(near.distance, 0.7f);
  EXPECT_EQ(near.direction[0], 0.7f);
  EXPECT_EQ(near.score[0], 0.3f);
  const PairPrediction far = Mix({SemanticFunction::kScores, SemanticFunction::kExplorable}, 0.0f);
  EXPECT_EQ(far.same_node, 0.4f);
  EXPECT_EQ(far.distance, 0.3f);
  EXPECT_EQ(far.score[0], 0.7f);
}

TEST(MixedSemanticModel, KeepsTheModelsAnswerWhereTheOracleHasNone) {
  EXPECT_EQ(Mix({SemanticFunction::kPose}, 0.0f).distance, 0.3f);
  EXPECT_EQ(Mix({SemanticFunction::kScores}, 1.0f).score[0], 0.3f);
}

}  // namespace
}  // namespace bulletnav::bench
