// SPDX-License-Identifier: MIT
#include "agent/policy/policy_net.h"

#include <algorithm>

#include <gmock/gmock.h>

#include "agent/integer/quantised_file.h"
#include "agent/models/model_registry.h"
#include "agent/perception/semantic_net.h"
#include "agent/policy/learned_policy.h"
#include "agent/policy/quantise_policy.h"
#include "agent/policy/stitch_policy.h"
#include "sim/base/error.h"
#include "tests/agent/policy/small_policies.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::agent {
namespace {

using tests::BytesOf;
using tests::SmallPolicy;
using tests::SomePanoramas;

Rig WholeRig() {
  Rig rig;
  rig.panorama.rows = 128;
  rig.panorama.cols = 512;
  return rig;
}

class PolicyNetTest : public testing::TestWithParam<PolicyConfig> {
 protected:
  PolicyNetTest() {
    const torch::NoGradGuard no_grad;
    const torch::Tensor codes = net_.Encode(Pictures());
    seen_.codes = codes.view({3, 2, -1});
    seen_.goals = codes.flip(0).view({3, 2, -1});
    seen_.numbers = torch::linspace(-1, 1, 48).view({3, 2, 8});
  }
  torch::Tensor Pictures() const {
    const torch::Tensor bytes = BytesOf(panoramas_, 32);
    return GetParam().map ? tests::WithMaps(bytes) : bytes;
  }
  const std::vector<tests::RandomPanorama> panoramas_ = SomePanoramas(1, 6);
  PolicyNet net_{GetParam(), 3};
  PolicyNet::Seen seen_;
  const torch::Tensor start_ = torch::tensor({1.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f}).view({3, 2});
  const torch::Tensor memory_ = torch::full({2, 32}, 0.5f);
};

TEST_P(PolicyNetTest, ASequenceIsItsStepsOneByOne) {
  const torch::NoGradGuard no_grad;
  const PolicyNet::Output whole = net_.Run(seen_, start_, memory_);
  torch::Tensor memory = memory_;
  for (int t = 0; t < 3; ++t) {
    const auto at = [&](const torch::Tensor& all) {
      return all.narrow(0, t, 1);
    };
    const PolicyNet::Output one =
        net_.Run({at(seen_.codes), at(seen_.goals), at(seen_.numbers)}, at(start_), memory);
    memory = one.memory;
    EXPECT_LT((one.logits[0] - whole.logits[t]).abs().max().item<float>(), 1e-5f);
    EXPECT_LT((one.values[0] - whole.values[t]).abs().max().item<float>(), 1e-5f);
  }
  EXPECT_LT((memory - whole.memory).abs().max().item<float>(), 1e-5f);
}

TEST_P(PolicyNetTest, StopsSeldomAtFirstAndChoosesEvenlyElse) {
  const torch::NoGradGuard no_grad;
  const torch::Tensor shares = net_.Run(seen_, start_, memory_).logits.softmax(-1);
  const torch::Tensor stop = shares.select(-1, 0);
  EXPECT_LT((stop - 0.02).abs().max().item<float>(), 0.005f);
  EXPECT_LT((shares.narrow(-1, 1, 3) - 0.98 / 3).abs().max().item<float>(), 0.05f);
}

TEST_P(PolicyNetTest, AllParametersLearn) {
  const PolicyNet::Seen seen = {net_.Encode(Pictures()).view({3, 2, -1}), seen_.goals,
                                seen_.numbers};
  const PolicyNet::Output output = net_.Run(seen, start_, memory_);
  (output.logits.square().sum() + output.values.sum()).backward();
  for (const auto& item : net_.named_parameters()) {
    ASSERT_TRUE(item.value().grad().defined()) << item.key();
    EXPECT_GT(item.value().grad().abs().max().item<float>(), 0.0f) << item.key();
  }
}

TEST_P(PolicyNetTest, IsLoadedAsItWasSaved) {
  const tests::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "policy.safetensors";
  SavePolicy(net_, {{"frames", "7"}}, StoredType::kFloat32, file);
  const std::shared_ptr<PolicyNet> again = LoadPolicy(file);
  EXPECT_EQ(again->config(), net_.config());
  const torch::NoGradGuard no_grad;
  EXPECT_TRUE(at::equal(again->Run(seen_, start_, memory_).logits,
                        net_.Run(seen_, start_, memory_).logits));
  const auto model = std::dynamic_pointer_cast<PolicyModel>(LoadModel(file, WholeRig()));
  ASSERT_NE(model, nullptr);
  std::vector<float> memory = model->NoMemory();
  const std::vector<float> numbers(kPolicyNumbers);
  const std::vector<float> goal = model->CodeOf(panoramas_[1].view());
  const std::vector<std::uint8_t> map = tests::RandomMap(1);
  EXPECT_EQ(model->sees_map(), GetParam().map);
  PolicyQuestion question = {panoramas_[0].view(), goal, numbers};
  if (GetParam().map) question.map = map;
  const auto shares = model->Act(question, &memory);
  EXPECT_NEAR(shares[0] + shares[1] + shares[2] + shares[3], 1.0f, 1e-5f);
  Rig small = WholeRig();
  small.panorama.rows = 64;
  EXPECT_THROW(LoadModel(file, small), sim::Error);
}

INSTANTIATE_TEST_SUITE_P(Fusions, PolicyNetTest,
                         testing::Values(SmallPolicy(Fusion::kLate),
                                         SmallPolicy(Fusion::kCorrelation),
                                         tests::SmallMapPolicy()),
                         [](const auto& one) {
                           return std::string(sim::NameOf(one.param.fusion)) +
                                  (one.param.map ? "_map" : "");
                         });

TEST(PolicyNet, AMapDoesNotMatterOfAGoalAndDoesOfWhatIsSeen) {
  const torch::NoGradGuard no_grad;
  PolicyNet net(tests::SmallMapPolicy(), 3);
  const torch::Tensor bytes = BytesOf(SomePanoramas(1, 2), 32);
  const torch::Tensor one = net.Encode(tests::WithMaps(bytes)).view({1, 2, -1});
  const torch::Tensor blank =
      net.Encode(
             at::cat({bytes, torch::zeros({2, std::int64_t{kPolicyMapBytes}}, torch::kUInt8)}, 1))
          .view({1, 2, -1});
  const auto values = [&](const torch::Tensor& codes, const torch::Tensor& goals) {
    return net
        .Run({codes, goals, torch::zeros({1, 2, kPolicyNumbers})}, torch::ones({1, 2}),
             torch::zeros({2, 32}))
        .values;
  };
  EXPECT_TRUE(at::equal(values(one, one), values(one, blank)));
  EXPECT_GT((values(one, one) - values(blank, one)).abs().max().item<float>(), 1e-3f);
}

TEST(PolicyEncoder, BeginsWithThatOfASemanticModel) {
  const tests::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "nts.safetensors";
  ModelConfig config = SmallPolicy().seeing();
  config.norm = Norm::kBatch;
  SemanticNet semantic(config, 9);
  SaveNet(semantic, {}, StoredType::kFloat32, file);
  PolicyNet net(SmallPolicy(), 1);
  TakeEncoder(file, &net);
  semantic.eval();
  const torch::NoGradGuard no_grad;
  const torch::Tensor pictures = BytesOf(SomePanoramas(2, 2), 32);
  const torch::Tensor input = PolicyInput(net.config(), pictures);
  // The semantic model's own is asked through a part of its answers.
  auto encoder = std::dynamic_pointer_cast<Encoder>(semantic.named_children()["encoder"]);
  ASSERT_NE(encoder, nullptr);
  EXPECT_LT(
      (encoder->forward(input).view({2, -1}) - net.Encode(pictures)).abs().max().item<float>(),
      1e-3f);

  PolicyConfig wide = SmallPolicy();
  wide.width = 32;
  PolicyNet other(wide, 1);
  EXPECT_THROW(TakeEncoder(file, &other), sim::FileError);
  EXPECT_THROW(TakeIntegerEncoder(file, &net), sim::FileError);
}

TEST(PolicyEncoder, OfAModelOfColourDoesNotHeedDepthAtFirst) {
  const tests::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "nts.safetensors";
  ModelConfig config = SmallPolicy().seeing();
  config.norm = Norm::kBatch;
  config.depth = DepthFusion::kNone;
  SemanticNet semantic(config, 9);
  SaveNet(semantic, {}, StoredType::kFloat32, file);
  PolicyNet net(SmallPolicy(), 1);
  TakeEncoder(file, &net);
  semantic.eval();
  const torch::NoGradGuard no_grad;
  const torch::Tensor pictures = BytesOf(SomePanoramas(2, 2), 32);
  const torch::Tensor blind = pictures.clone();
  blind.view({2, -1, 4}).select(2, 3).zero_();
  EXPECT_TRUE(at::equal(net.Encode(pictures), net.Encode(blind)));
  auto encoder = std::dynamic_pointer_cast<Encoder>(semantic.named_children()["encoder"]);
  ASSERT_NE(encoder, nullptr);
  const torch::Tensor color = PolicyInput(net.config(), pictures).narrow(1, 0, 3);
  EXPECT_LT(
      (encoder->forward(color).view({2, -1}) - net.Encode(pictures)).abs().max().item<float>(),
      1e-3f);
}

/// The encoder of `net` in integers, with the channels of its codes turned by `shift`.
QuantisedNet TurnedChannels(QuantisedNet net, int shift) {
  QuantisedLayer& layer = net.layers.at("encoder.second");
  const QuantisedLayer before = layer;
  for (int o = 0; o < layer.outputs; ++o) {
    const auto from = static_cast<std::size_t>((o + shift) % layer.outputs);
    const auto to = static_cast<std::size_t>(o);
    const auto row = static_cast<std::size_t>(layer.inputs);
    std::copy_n(before.weights.begin() + static_cast<std::ptrdiff_t>(from * row), row,
                layer.weights.begin() + static_cast<std::ptrdiff_t>(to * row));
    layer.scale[to] = before.scale[from];
    layer.bias[to] = before.bias[from];
  }
  return net;
}

TEST(StitchPolicy, ActsAsBeforeThroughAnEncoderOfTheSameCodesInAnotherOrder) {
  const torch::NoGradGuard no_grad;
  PolicyConfig config = SmallPolicy();
  PolicyNet own(config, 4);
  const torch::Tensor pictures = BytesOf(SomePanoramas(1, 140), 32);
  const QuantisedNet encoder =
      Quantise(&own, {pictures, pictures, torch::zeros({140, kPolicyNumbers})});
  config.own_encoder = false;
  PolicyNet net(config, 4);
  net.SeeWith(std::make_shared<IntegerSight>(encoder, config.rows));
  const auto logits = [&] {
    const torch::Tensor codes = net.Encode(pictures.narrow(0, 0, 8)).view({1, 8, -1});
    return net
        .Run({codes, codes.roll(3, 1), torch::zeros({1, 8, kPolicyNumbers})}, torch::ones({1, 8}),
             torch::zeros({8, 32}))
        .logits;
  };
  const torch::Tensor before = logits();
  const auto turned = std::make_shared<IntegerSight>(TurnedChannels(encoder, 5), config.rows);
  EXPECT_GT(StitchPolicy({pictures, pictures}, turned, &net), 0.99);
  const torch::Tensor after = logits();
  const float spread = (before - before.mean(1, true)).abs().max().item<float>();
  EXPECT_LT((after - before).abs().max().item<float>(), 0.1f * spread);
  EXPECT_EQ(net.sight(), turned);
  const torch::Tensor few = pictures.narrow(0, 0, 20);
  EXPECT_THROW(StitchPolicy({few, few}, turned, &net), sim::Error);
}

TEST(WithoutDepth, IsWhatAPanoramaOfColourAloneIs) {
  const std::vector<tests::RandomPanorama> panoramas = SomePanoramas(3, 2);
  const torch::Tensor color = WithoutDepth(BytesOf(panoramas, 32));
  PolicyPictures pictures(32);
  for (std::int64_t i = 0; i < 2; ++i) {
    torch::Tensor alone = torch::ones_like(color[i]);
    pictures.Write({panoramas[static_cast<std::size_t>(i)].color, {}},
                   {alone.data_ptr<std::uint8_t>(), pictures.bytes()});
    EXPECT_TRUE(at::equal(color[i], alone));
  }
}

TEST(TakePolicy, APolicyWithAMapBeginsAsOneWithout) {
  const torch::NoGradGuard no_grad;
  const tests::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "policy.safetensors";
  PolicyNet plain(SmallPolicy(Fusion::kLate), 3);
  SavePolicy(plain, {}, StoredType::kFloat32, file);
  PolicyNet mapping(tests::SmallMapPolicy(), 9);
  TakePolicy(file, &mapping);
  const torch::Tensor bytes = BytesOf(SomePanoramas(1, 2), 32);
  const auto logits = [](PolicyNet* net, const torch::Tensor& pictures) {
    const torch::Tensor codes = net->Encode(pictures).view({1, 2, -1});
    return net
        ->Run({codes, codes, torch::zeros({1, 2, kPolicyNumbers})}, torch::ones({1, 2}),
              torch::zeros({2, 32}))
        .logits;
  };
  EXPECT_LT(
      (logits(&plain, bytes) - logits(&mapping, tests::WithMaps(bytes))).abs().max().item<float>(),
      1e-6f);
  PolicyNet other(SmallPolicy(Fusion::kCorrelation), 9);
  EXPECT_THROW(TakePolicy(file, &other), sim::FileError);
}

TEST(TakePolicy, APolicyWithItsOwnEncoderKeepsItAndOneWithoutLeavesTheOthers) {
  const torch::NoGradGuard no_grad;
  const tests::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "policy.safetensors";
  const torch::Tensor pictures = BytesOf(SomePanoramas(1, 4), 32);
  PolicyNet own(SmallPolicy(), 3);
  const QuantisedNet encoder =
      Quantise(&own, {pictures, pictures, torch::zeros({4, kPolicyNumbers})});
  PolicyConfig config = SmallPolicy();
  config.own_encoder = false;
  PolicyNet seeing(config, 5);
  seeing.SeeWith(std::make_shared<IntegerSight>(encoder, config.rows));
  SavePolicy(seeing, {}, StoredType::kFloat32, file);
  const torch::Tensor before = own.Encode(pictures);
  const auto whole = [](const PolicyNet& net) {
    return net.named_parameters()["whole.weight"];
  };
  EXPECT_FALSE(at::equal(whole(own), whole(seeing)));
  TakePolicy(file, &own);
  EXPECT_TRUE(at::equal(whole(own), whole(seeing)));
  EXPECT_TRUE(at::equal(own.Encode(pictures), before));

  SavePolicy(own, {}, StoredType::kFloat32, file);
  AddQuantised(encoder, file, file);
  PolicyNet back(config, 7);
  back.SeeWith(seeing.sight());
  TakePolicy(file, &back);
  EXPECT_TRUE(at::equal(whole(back), whole(own)));
}

}  // namespace
}  // namespace bulletnav::agent
