// SPDX-License-Identifier: MIT
#include "agent/policy/integer_policy.h"

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "agent/integer/quantised_file.h"
#include "agent/models/model_registry.h"
#include "agent/policy/learned_policy.h"
#include "agent/policy/quantise_policy.h"
#include "agent/policy/restore_policy.h"
#include "sim/base/error.h"
#include "tests/agent/policy/small_policies.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::agent {
namespace {

using tests::BytesOf;
using tests::RandomPanorama;
using tests::SmallPolicy;
using tests::SomePanoramas;

/// A net whose answers differ: heads as they begin hardly look.
std::shared_ptr<PolicyNet> Decided(const PolicyConfig& config, std::uint64_t seed = 4) {
  auto net = std::make_shared<PolicyNet>(config, seed);
  const torch::NoGradGuard no_grad;
  net->named_parameters()["policy_head.weight"].mul_(100.0);
  net->eval();
  return net;
}

QuantisedNet QuantisedOf(PolicyNet* net) {
  torch::Tensor pictures = BytesOf(SomePanoramas(1, 24), 32);
  if (net->config().map) pictures = tests::WithMaps(pictures);
  sim::Rng rng(1, "numbers");
  return Quantise(net,
                  {pictures, pictures.roll(5, 0), NormalTensor({24, kPolicyNumbers}, 0.5, &rng)});
}

/// What a policy says along a walk.
std::vector<std::array<float, 4>> Walk(PolicyModel* policy) {
  std::vector<float> memory = policy->NoMemory();
  const std::vector<float> goal = policy->CodeOf(RandomPanorama(900).view());
  std::vector<std::array<float, 4>> all;
  for (std::uint64_t step = 0; step < 24; ++step) {
    std::vector<float> numbers(kPolicyNumbers);
    numbers[1 + step % 3] = 1.0f;
    numbers[4] = 0.9f;
    numbers[7] = static_cast<float>(step) / 500.0f;
    const std::vector<std::uint8_t> map = tests::RandomMap(step);
    const RandomPanorama panorama(700 + step);
    PolicyQuestion question = {panorama.view(), goal, numbers};
    if (policy->sees_map()) question.map = map;
    all.push_back(policy->Act(question, &memory));
  }
  return all;
}

class IntegerPolicyTest : public testing::TestWithParam<PolicyConfig> {};

TEST_P(IntegerPolicyTest, SaysWhatTheTrainedOneSays) {
  const std::shared_ptr<PolicyNet> net = Decided(GetParam());
  IntegerPolicy integers(net->config(), QuantisedOf(net.get()));
  LearnedPolicy floats(net);
  const auto exact = Walk(&floats);
  const auto close = Walk(&integers);
  float apart = 0.0f;
  float spread = 0.0f;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    for (std::size_t k = 0; k < 4; ++k) {
      apart = std::max(apart, std::fabs(exact[i][k] - close[i][k]));
      spread = std::max(spread, std::fabs(exact[i][k] - exact[0][k]));
    }
  }
  EXPECT_GT(spread, 0.1f);  // or there was nothing to say
  EXPECT_LT(apart, 0.04f);
}

TEST_P(IntegerPolicyTest, HasTheSameBitsWithAllKernels) {
  const std::shared_ptr<PolicyNet> net = Decided(GetParam());
  const QuantisedNet quantised = QuantisedOf(net.get());
  IntegerPolicy fastest(net->config(), quantised);
  const auto expected = Walk(&fastest);
  for (const IntegerKernels* kernels : SupportedIntegerKernels()) {
    IntegerPolicy policy(net->config(), quantised);
    policy.Use(*kernels);
    EXPECT_EQ(Walk(&policy), expected) << kernels->name;
  }
}

TEST_P(IntegerPolicyTest, IsWhatAFileOfBothIsLoadedAs) {
  const std::shared_ptr<PolicyNet> net = Decided(GetParam());
  const tests::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "policy.safetensors";
  SavePolicy(*net, {}, StoredType::kFloat32, file);
  const QuantisedNet quantised = QuantisedOf(net.get());
  AddQuantised(quantised, file, file);
  Rig rig;
  rig.panorama.rows = 128;
  rig.panorama.cols = 512;
  rig.has_depth = GetParam().map;
  const std::shared_ptr<Model> model = LoadModel(file, rig);
  EXPECT_NE(std::dynamic_pointer_cast<IntegerPolicy>(model), nullptr);
  EXPECT_TRUE(HoldsIntegers(ReadTensorFile(file)));
  EXPECT_NO_THROW(LoadPolicy(file));

  TensorFile broken = ReadTensorFile(file);
  broken.tensors.erase("integer.joined.step");
  WriteTensorFile(file, broken, StoredType::kFloat32);
  EXPECT_THROW(LoadModel(file, rig), sim::FileError);
}

TEST_P(IntegerPolicyTest, SeesWithAnEncoderThatWasNotTrained) {
  const std::shared_ptr<PolicyNet> own = Decided(GetParam());
  PolicyConfig config = own->config();
  config.own_encoder = false;
  PolicyNet net(config, 4);
  net.SeeWith(std::make_shared<IntegerSight>(QuantisedOf(own.get()), config.rows));
  const tests::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "policy.safetensors";
  SavePolicy(net, {}, StoredType::kFloat32, file);
  // The encoder alone is in integers, so that the trained numbers act.
  EXPECT_FALSE(HoldsIntegers(ReadTensorFile(file)));
  const std::shared_ptr<PolicyNet> again = LoadPolicy(file);
  torch::Tensor pictures = BytesOf(SomePanoramas(3, 2), 32);
  if (config.map) pictures = tests::WithMaps(pictures);
  EXPECT_TRUE(at::equal(again->Encode(pictures), net.Encode(pictures)));
  AddQuantised(QuantisedOf(again.get()), file, file);
  EXPECT_TRUE(HoldsIntegers(ReadTensorFile(file)));

  // It is gone on from with the same encoder alone.
  PolicyNet next(config, 5);
  TakeIntegerEncoder(file, &next);
  EXPECT_NO_THROW(TakePolicy(file, &next));
  const std::shared_ptr<PolicyNet> stranger = Decided(GetParam(), 8);
  next.SeeWith(std::make_shared<IntegerSight>(QuantisedOf(stranger.get()), config.rows));
  EXPECT_THROW(TakePolicy(file, &next), sim::FileError);
}

TEST_P(IntegerPolicyTest, KeepsEachNumberOnceAndRestoresIt) {
  const torch::NoGradGuard no_grad;
  const std::shared_ptr<PolicyNet> net = Decided(GetParam());
  const QuantisedNet quantised = QuantisedOf(net.get());
  const std::vector<std::string> once = RestoredNumbers(quantised);
  const tests::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "policy.safetensors";
  SavePolicy(*net, {}, StoredType::kFloat32, file);
  AddQuantised(quantised, file, file, once);
  const TensorFile stored = ReadTensorFile(file);
  for (const std::string& name : once) EXPECT_FALSE(stored.tensors.contains(name)) << name;
  EXPECT_TRUE(stored.tensors.contains("value_head.weight"));

  const auto expected = net->named_parameters();
  const std::shared_ptr<PolicyNet> again = LoadPolicy(file);
  for (const auto& item : again->named_parameters()) {
    const torch::Tensor trained = expected[item.key()];
    const float apart = (item.value() - trained).abs().max().item<float>();
    EXPECT_LE(apart, trained.abs().max().item<float>() / 1000) << item.key();
  }
  PolicyNet next(GetParam(), 7);
  TakePolicy(file, &next);
  EXPECT_TRUE(at::equal(next.named_parameters()["joined.weight"],
                        again->named_parameters()["joined.weight"]));

  TensorFile broken = stored;
  broken.tensors.erase("integer.whole.step");
  WriteTensorFile(file, broken, StoredType::kFloat32);
  EXPECT_THROW(LoadPolicy(file), sim::FileError);
  broken = stored;
  broken.tensors.erase("integer.gru_in.weight");
  WriteTensorFile(file, broken, StoredType::kFloat32);
  EXPECT_THROW(LoadPolicy(file), sim::FileError);
}

TEST(IntegerPolicy, WithAMapNeedsDepth) {
  const std::shared_ptr<PolicyNet> net = Decided(tests::SmallMapPolicy());
  const tests::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "policy.safetensors";
  SavePolicy(*net, {}, StoredType::kFloat32, file);
  Rig rig;
  EXPECT_NO_THROW(LoadModel(file, rig));
  rig.has_depth = false;
  EXPECT_THROW(LoadModel(file, rig), sim::FileError);
  AddQuantised(QuantisedOf(net.get()), file, file);
  EXPECT_THROW(LoadModel(file, rig), sim::FileError);
}

TEST(IntegerPolicy, ActsInTheSettingOfItsTrainingAlone) {
  const std::shared_ptr<PolicyNet> net = Decided(SmallPolicy(Fusion::kLate));
  const tests::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "policy.safetensors";
  const auto acts = [&](bool has_depth) {
    Rig rig;
    rig.has_depth = has_depth;
    try {
      LoadModel(file, rig);
    } catch (const sim::FileError& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr("trained in the setting rgb"));
      return false;
    }
    return true;
  };
  struct Case {
    std::map<std::string, std::string> notes;
    bool with_depth, without;
  };
  const std::vector<Case> cases = {
      {{}, true, true},
      {{{"training", "task: ppo\nsetting: rgbd\n"}}, true, false},
      {{{"training", "setting: rgb"}}, false, true},
      {{{"training", "setting: both"}}, true, true},
      {{{"training", "setting: rgbd"}, {"stitched", "to another"}}, true, true}};
  for (const Case& one : cases) {
    SavePolicy(*net, one.notes, StoredType::kFloat32, file);
    EXPECT_EQ(acts(true), one.with_depth);
    EXPECT_EQ(acts(false), one.without);
    AddQuantised(QuantisedOf(net.get()), file, file);
    EXPECT_EQ(acts(true), one.with_depth);
    EXPECT_EQ(acts(false), one.without);
  }
}

TEST(IntegerPolicy, ActsInTheBodyOfItsTrainingAlone) {
  const tests::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "policy.safetensors";
  SavePolicy(*Decided(SmallPolicy(Fusion::kLate)), {}, StoredType::kFloat32, file);
  Rig low;
  low.camera_height = 0.4f;
  EXPECT_THROW(LoadModel(file, low), sim::FileError);
  Rig near;
  near.panorama.max_depth_m = 3.0f;
  EXPECT_THROW(LoadModel(file, near), sim::FileError);
  Rig wide;
  wide.body_radius = 0.18f;
  EXPECT_THROW(LoadModel(file, wide), sim::FileError);
  Rig short_one;
  short_one.body_height = 0.88f;
  EXPECT_THROW(LoadModel(file, short_one), sim::FileError);
  Rig other;
  other.panorama.projection = sim::Projection::kEquirectangular;
  EXPECT_THROW(LoadModel(file, other), sim::FileError);
}

TEST(IntegerPolicy, RefusesLayersOfAnotherShape) {
  const std::shared_ptr<PolicyNet> net = Decided(SmallPolicy(Fusion::kCorrelation));
  const QuantisedNet quantised = QuantisedOf(net.get());
  PolicyConfig config = net->config();
  config.memory = 64;
  EXPECT_THROW(IntegerPolicy(config, quantised), sim::Error);
  QuantisedNet missing = quantised;
  missing.layers.erase("gru_in");
  EXPECT_THROW(IntegerPolicy(net->config(), missing), sim::Error);
}

INSTANTIATE_TEST_SUITE_P(Fusions, IntegerPolicyTest,
                         testing::Values(SmallPolicy(Fusion::kLate),
                                         SmallPolicy(Fusion::kCorrelation),
                                         tests::SmallMapPolicy()),
                         [](const auto& one) {
                           return std::string(sim::NameOf(one.param.fusion)) +
                                  (one.param.map ? "_map" : "");
                         });

}  // namespace
}  // namespace bulletnav::agent
