// SPDX-License-Identifier: MIT
#include "agent/perception/semantic_net.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>

#include "agent/models/semantic_model.h"
#include "agent/perception/weights.h"
#include "sim/base/error.h"
#include "sim/math/pose.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::agent {
namespace {

using ::testing::HasSubstr;

ModelConfig Tiny(EncoderForm form, DepthFusion depth = DepthFusion::kChannel) {
  ModelConfig config;
  config.encoder = form;
  config.depth = depth;
  config.width = 8;
  config.rows = 32;
  config.pair_features = 32;
  config.precision = Precision::kFloat32;
  return config;
}

struct Pictures {
  torch::Tensor color;
  torch::Tensor depth;
};

/// Noise, the same for the same seed.
Pictures Noise(int count, std::uint64_t seed) {
  const at::Generator generator = at::detail::createCPUGenerator(seed);
  return {torch::randint(0, 256, {count, 128, 512, 3}, generator, torch::kUInt8),
          torch::rand({count, 128, 512}, generator) * 12.0};
}

Pictures Rolled(const Pictures& p, int columns) {
  return {p.color.roll(columns, 2), p.depth.roll(columns, 2)};
}

double LargestDifference(const torch::Tensor& a, const torch::Tensor& b) {
  return (a - b).abs().max().item<double>();
}

class EncoderForms : public testing::TestWithParam<EncoderForm> {};

// Column c looks at bearing pi - 2 pi (c + 1/2) / 512.
TEST_P(EncoderForms, PatchLooksAtItsBearing) {
  const ModelConfig config = Tiny(GetParam(), DepthFusion::kNone);
  SemanticNet net(config, 1);
  net.eval();
  sim::Rng rng(1, "semantic_net");
  Encoder encoder(config, &rng);
  encoder.eval();
  for (int i = 0; i < kDirections; ++i) {
    torch::Tensor input = PrepareInput(config, Noise(4, 7).color, {}).detach();
    input.requires_grad_(true);
    encoder.forward(input).select(1, i).sum().backward();
    const torch::Tensor weight = input.grad().abs().sum({0, 1, 2});
    double x = 0.0;
    double y = 0.0;
    for (int c = 0; c < config.cols(); ++c) {
      const double bearing = sim::kPi - 2.0 * sim::kPi * (c + 0.5) / config.cols();
      x += weight[c].item<double>() * std::cos(bearing);
      y += weight[c].item<double>() * std::sin(bearing);
    }
    const double error = sim::WrapAngle(std::atan2(y, x) - 2.0 * sim::kPi * i / kDirections);
    EXPECT_NEAR(error, 0.0, 0.2) << "patch " << i;
  }
}

TEST_P(EncoderForms, QuarterTurnPermutesTheCodes) {
  for (const DepthFusion depth :
       {DepthFusion::kNone, DepthFusion::kChannel, DepthFusion::kSeparate}) {
    const ModelConfig config = Tiny(GetParam(), depth);
    sim::Rng rng(1, "encoder");
    Encoder encoder(config, &rng);
    encoder.eval();
    const torch::NoGradGuard no_grad;
    const Pictures before = Noise(1, 3);
    // Content 90 degrees to the left moves 128 columns left, and three directions on.
    const Pictures after = Rolled(before, -128);
    const torch::Tensor expected =
        encoder.forward(PrepareInput(config, before.color, before.depth)).roll(3, 1);
    const torch::Tensor codes = encoder.forward(PrepareInput(config, after.color, after.depth));
    EXPECT_LT(LargestDifference(codes, expected), 1e-4);
    EXPECT_GT(LargestDifference(codes, expected.roll(1, 1)), 1e-2);
  }
}

INSTANTIATE_TEST_SUITE_P(All, EncoderForms,
                         testing::Values(EncoderForm::kPanorama, EncoderForm::kPatches),
                         [](const auto& form) {
                           return std::string(sim::NameOf(form.param));
                         });

TEST(SemanticNet, MapOfPanoramasHasTheSamePatchesAtEverySize) {
  for (const int rows : {32, 64, 128}) {
    ModelConfig config = Tiny(EncoderForm::kPanorama);
    config.rows = rows;
    SemanticNet net(config, 1);
    const Pictures pictures = Noise(2, 3);
    const PanoramaParts parts = net.Describe(PrepareInput(config, pictures.color, pictures.depth));
    EXPECT_EQ(parts.explorable.sizes(), (std::vector<std::int64_t>{2, 12}));
    EXPECT_EQ(parts.source_sum.sizes(), (std::vector<std::int64_t>{2, 12, 32}));
  }
}

/// Answers turn with the source's codes and do not care for the goal's.
TEST(Heads, TurningTheSourceTurnsAnswersTurningTheGoalDoesNot) {
  const ModelConfig config = Tiny(EncoderForm::kPanorama);
  sim::Rng rng(5, "heads");
  Heads heads(config, &rng);
  const torch::NoGradGuard no_grad;
  const at::Generator generator = at::detail::createCPUGenerator(2);
  const torch::Tensor source = torch::rand({3, 12, kCodeSize}, generator);
  const torch::Tensor goal = torch::rand({3, 12, kCodeSize}, generator);
  const auto answers = [&](int source_turn, int goal_turn) {
    return heads.Compare(heads.Describe(source.roll(source_turn, 1)),
                         heads.Describe(goal.roll(goal_turn, 1)));
  };
  const PairOutputs still = answers(0, 0);
  EXPECT_GT(LargestDifference(still.direction, still.direction.roll(1, 1)), 1e-3);
  for (const int turn : {1, 5, 11}) {
    const PairOutputs turned = answers(turn, (3 * turn) % 12);
    EXPECT_LT(LargestDifference(turned.same_node, still.same_node), 1e-5);
    EXPECT_LT(LargestDifference(turned.distance_score, still.distance_score), 1e-5);
    EXPECT_LT(LargestDifference(turned.direction, still.direction.roll(turn, 1)), 1e-5);
    EXPECT_LT(LargestDifference(turned.scores, still.scores.roll(turn, 1)), 1e-5);
    EXPECT_LT(LargestDifference(heads.Describe(source.roll(turn, 1)).explorable,
                                heads.Describe(source).explorable.roll(turn, 1)),
              1e-5);
  }
}

/// A goal that shows the source's own patches is told from one whose patches are in another order.
TEST(Heads, SeeTheOrderOfPatches) {
  sim::Rng rng(5, "heads");
  Heads heads(Tiny(EncoderForm::kPanorama), &rng);
  const torch::NoGradGuard no_grad;
  const torch::Tensor source = torch::rand({1, 12, kCodeSize}, at::detail::createCPUGenerator(2));
  const PanoramaParts parts = heads.Describe(source);
  const torch::Tensor same = heads.Compare(parts, parts).same_node;
  const torch::Tensor mirrored = heads.Compare(parts, heads.Describe(source.flip(1))).same_node;
  EXPECT_GT(LargestDifference(same, mirrored), 1e-4);
}

TEST(SemanticNet, SameSeedSameWeights) {
  TensorFile a;
  TensorFile b;
  TensorFile c;
  AppendWeights(SemanticNet(Tiny(EncoderForm::kPanorama), 1), "", &a);
  AppendWeights(SemanticNet(Tiny(EncoderForm::kPanorama), 1), "", &b);
  AppendWeights(SemanticNet(Tiny(EncoderForm::kPanorama), 2), "", &c);
  EXPECT_EQ(a.tensors, b.tensors);
  EXPECT_NE(a.tensors, c.tensors);
}

TEST(SemanticNet, FoldingChangesAnswersByRoundingOnly) {
  const ModelConfig config = Tiny(EncoderForm::kPanorama, DepthFusion::kSeparate);
  SemanticNet net(config, 1);
  const Pictures pictures = Noise(2, 3);
  const torch::Tensor input = PrepareInput(config, pictures.color, pictures.depth);
  const torch::NoGradGuard no_grad;
  for (int i = 0; i < 3; ++i) net.Describe(input);  // moves the running means
  net.eval();
  const torch::Tensor before = net.Describe(input).source_sum;
  net.Fold();
  EXPECT_LT(LargestDifference(net.Describe(input).source_sum, before),
            1e-4 * before.abs().max().item<double>());
}

TEST(SemanticNet, WeightsComeBackThroughAFile) {
  const tests::TemporaryFolder folder;
  const auto file = folder.path() / "w.safetensors";
  const SemanticNet net(Tiny(EncoderForm::kPatches, DepthFusion::kSeparate), 4);
  SaveNet(net, {{"trained", "never"}}, StoredType::kFloat32, file);
  const auto read = LoadNet(file);
  EXPECT_EQ(read->config(), net.config());
  TensorFile before;
  TensorFile after;
  AppendWeights(net, "", &before);
  AppendWeights(*read, "", &after);
  EXPECT_EQ(before.tensors, after.tensors);
}

/// What FileError says about setting these weights.
std::string Complaint(const TensorFile& weights, const ModelConfig& config) {
  SemanticNet net(config, 1);
  try {
    SetWeights(weights, "", "weights.safetensors", &net);
  } catch (const sim::FileError& e) {
    return e.what();
  }
  return "none";
}

TEST(SemanticNet, RefusesWeightsOfAnotherModel) {
  const ModelConfig config = Tiny(EncoderForm::kPanorama);
  TensorFile weights;
  AppendWeights(SemanticNet(config, 1), "", &weights);
  EXPECT_EQ(Complaint(weights, config), "none");
  ModelConfig wider = config;
  wider.width = 16;
  EXPECT_THAT(Complaint(weights, wider), HasSubstr("has shape"));
  EXPECT_THAT(Complaint(weights, Tiny(EncoderForm::kPanorama, DepthFusion::kSeparate)),
              HasSubstr("weights of another model"));
  TensorFile less = weights;
  less.tensors.erase(less.tensors.begin());
  EXPECT_THAT(Complaint(less, config), HasSubstr("is missing"));
  TensorFile more = weights;
  more.tensors["stranger"] = {{1}, {0.0f}};
  EXPECT_THAT(Complaint(more, config), HasSubstr("stranger"));
}

TEST(SemanticNet, RefusesWeightsThatAreNoNumbers) {
  const ModelConfig config = Tiny(EncoderForm::kPanorama);
  for (const float bad :
       {std::numeric_limits<float>::quiet_NaN(), -std::numeric_limits<float>::infinity()}) {
    TensorFile weights;
    AppendWeights(SemanticNet(config, 1), "", &weights);
    weights.tensors.rbegin()->second.values.back() = bad;
    EXPECT_THAT(Complaint(weights, config),
                HasSubstr(weights.tensors.rbegin()->first + ": holds numbers that are NaN"));
  }
}

TEST(SemanticNet, RefusesFilesWithoutAConfiguration) {
  const tests::TemporaryFolder folder;
  const auto file = folder.path() / "w.safetensors";
  WriteTensorFile(file, {});
  EXPECT_THROW(LoadNet(file), sim::FileError);
  WriteTensorFile(file, {{}, {{"model", "width: 7\n"}}});
  EXPECT_THROW(LoadNet(file), sim::FileError);
  WriteTensorFile(file, {{}, {{"model", "widht: 16\n"}}});
  EXPECT_THROW(LoadNet(file), sim::FileError);
}

TEST(ModelConfig, RefusesWhatCannotBeBuilt) {
  ModelConfig config;
  EXPECT_NO_THROW(config.Validate());
  config.rows = 100;
  EXPECT_THROW(config.Validate(), sim::Error);
  config = {};
  config.width = 12;
  EXPECT_THROW(config.Validate(), sim::Error);
  config = {};
  config.dropout = 1.0;
  EXPECT_THROW(config.Validate(), sim::Error);
}

}  // namespace
}  // namespace bulletnav::agent
