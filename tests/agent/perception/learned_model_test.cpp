// SPDX-License-Identifier: MIT
#include "agent/perception/learned_model.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <thread>

#include <gtest/gtest.h>

#include "agent/perception/semantic_net.h"
#include "sim/base/error.h"
#include "sim/math/rng.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::agent {
namespace {

struct Picture {
  std::vector<std::uint8_t> color;
  std::vector<float> depth;
  Panorama panorama() const { return {color, depth}; }
};

Picture Noise(std::uint64_t seed) {
  sim::Rng rng(seed, "picture");
  Picture picture{std::vector<std::uint8_t>(128 * 512 * 3), std::vector<float>(128 * 512)};
  for (auto& value : picture.color) value = static_cast<std::uint8_t>(rng.Next() & 255u);
  for (float& value : picture.depth) value = static_cast<float>(rng.Uniform(0.0, 12.0));
  return picture;
}

std::filesystem::path SaveTiny(const tests::TemporaryFolder& folder, DepthFusion depth,
                               Precision precision = Precision::kBfloat16) {
  ModelConfig config;
  config.depth = depth;
  config.width = 16;
  config.pair_features = 32;
  config.precision = precision;
  const auto file = folder.path() / "tiny.safetensors";
  SaveNet(SemanticNet(config, 3), {}, StoredType::kFloat32, file);
  return file;
}

bool operator==(const PairPrediction& a, const PairPrediction& b) {
  return a.same_node == b.same_node && a.direction == b.direction && a.distance == b.distance &&
         a.score == b.score;
}

class LearnedModelTest : public testing::TestWithParam<Precision> {
 protected:
  tests::TemporaryFolder folder_;
};

TEST_P(LearnedModelTest, AnswersDoNotDependOnWhatElseIsAsked) {
  LearnedModel model(SaveTiny(folder_, DepthFusion::kChannel, GetParam()), Rig{});
  std::vector<Picture> pictures;
  std::vector<Panorama> panoramas;
  for (int i = 0; i < 4; ++i) pictures.push_back(Noise(static_cast<std::uint64_t>(i)));
  for (const Picture& picture : pictures) panoramas.push_back(picture.panorama());
  const std::vector<PanoramaCode> codes = model.Encode(panoramas);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(model.Encode(std::span(panoramas).subspan(i, 1)).front(), codes[i]);
  }
  const std::vector<const PanoramaCode*> all = {&codes[0], &codes[1], &codes[2]};
  const std::vector<PairPrediction> predictions = model.Compare(all, codes[3]);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::vector<const PanoramaCode*> one = {&codes[i]};
    EXPECT_TRUE(model.Compare(one, codes[3]).front() == predictions[i]);
  }
}

TEST_P(LearnedModelTest, AnswersAreTheSameInEveryThread) {
  const auto file = SaveTiny(folder_, DepthFusion::kChannel, GetParam());
  const Picture a = Noise(1);
  const Picture b = Noise(2);
  const auto ask = [&] {
    LearnedModel model(file, Rig{});
    const std::vector<Panorama> both = {a.panorama(), b.panorama()};
    const std::vector<PanoramaCode> codes = model.Encode(both);
    const std::vector<const PanoramaCode*> source = {codes.data()};
    return std::pair(codes, model.Compare(source, codes[1]).front());
  };
  const auto expected = ask();
  std::vector<std::thread> threads;
  std::vector<std::pair<std::vector<PanoramaCode>, PairPrediction>> answers(3);
  for (auto& answer : answers)
    threads.emplace_back([&] {
      answer = ask();
    });
  for (std::thread& thread : threads) thread.join();
  for (const auto& [codes, prediction] : answers) {
    EXPECT_EQ(codes, expected.first);
    EXPECT_TRUE(prediction == expected.second);
  }
}

INSTANTIATE_TEST_SUITE_P(All, LearnedModelTest,
                         testing::Values(Precision::kFloat32, Precision::kBfloat16),
                         [](const auto& precision) {
                           return std::string(sim::NameOf(precision.param));
                         });

TEST_F(LearnedModelTest, AnswersAreProbabilitiesAndMetres) {
  LearnedModel model(SaveTiny(folder_, DepthFusion::kNone), Rig{});
  const Picture picture = Noise(1);
  const std::vector<Panorama> panoramas = {picture.panorama()};
  const PanoramaCode code = model.Encode(panoramas).front();
  for (const float p : model.Explorable(code)) EXPECT_TRUE(p > 0.0f && p < 1.0f);
  const std::vector<const PanoramaCode*> source = {&code};
  const PairPrediction pair = model.Compare(source, code).front();
  EXPECT_TRUE(pair.same_node > 0.0f && pair.same_node < 1.0f);
  EXPECT_NEAR(std::accumulate(pair.direction.begin(), pair.direction.end(), 0.0), 1.0, 1e-5);
  EXPECT_TRUE(pair.distance > 0.0f && pair.distance < 3.0f);
  for (const float s : pair.score) EXPECT_TRUE(s > 0.0f && s < 1.0f);
}

TEST_F(LearnedModelTest, NearlyTheSameAsFloat32InBfloat16) {
  const Picture picture = Noise(1);
  const std::vector<Panorama> panoramas = {picture.panorama()};
  std::vector<PanoramaCode> codes;
  for (const Precision precision : {Precision::kFloat32, Precision::kBfloat16}) {
    LearnedModel model(SaveTiny(folder_, DepthFusion::kChannel, precision), Rig{});
    codes.push_back(model.Encode(panoramas).front());
  }
  double error = 0.0;
  double size = 0.0;
  for (std::size_t i = 0; i < codes[0].size(); ++i) {
    error += std::pow(codes[0][i] - codes[1][i], 2);
    size += std::pow(codes[0][i], 2);
  }
  EXPECT_LT(error, 1e-3 * size);
}

TEST_F(LearnedModelTest, RefusesRigsThatDoNotGiveWhatItTakes) {
  const auto weights = SaveTiny(folder_, DepthFusion::kChannel);
  Rig rig;
  EXPECT_NO_THROW(LearnedModel(weights, rig));
  rig.has_depth = false;
  EXPECT_THROW(LearnedModel(weights, rig), sim::Error);
  rig = {};
  rig.has_color = false;
  EXPECT_THROW(LearnedModel(weights, rig), sim::Error);
  rig = {};
  rig.panorama.cols = 256;
  EXPECT_THROW(LearnedModel(weights, rig), sim::Error);
  EXPECT_THROW(LearnedModel(folder_.path() / "none", Rig{}), sim::FileError);
}

}  // namespace
}  // namespace bulletnav::agent
