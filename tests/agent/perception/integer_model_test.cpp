// SPDX-License-Identifier: MIT
#include "agent/integer/integer_model.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "agent/integer/quantised_file.h"
#include "agent/models/model_registry.h"
#include "agent/perception/integer_models.h"
#include "agent/perception/learned_model.h"
#include "agent/perception/quantise.h"
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

/// Coloured boxes: noise alone would look the same everywhere once it is averaged.
Picture Boxes(std::uint64_t seed) {
  sim::Rng rng(seed, "boxes");
  Picture picture{std::vector<std::uint8_t>(128 * 512 * 3), std::vector<float>(128 * 512)};
  for (int box = 0; box < 60; ++box) {
    const int top = rng.Between(0, 100);
    const int left = rng.Between(0, 450);
    const int color = rng.Between(0, 0xffffff);
    const auto depth = static_cast<float>(rng.Uniform(0.0, 12.0));
    for (int row = top; row < std::min(128, top + 50); ++row) {
      for (int col = left; col < std::min(512, left + 80); ++col) {
        const auto pixel = static_cast<std::size_t>(row * 512 + col);
        for (std::size_t c = 0; c < 3; ++c) {
          picture.color[3 * pixel + c] = static_cast<std::uint8_t>(color >> (8 * c));
        }
        picture.depth[pixel] = depth;
      }
    }
  }
  return picture;
}

struct Pictures12 {
  std::vector<Picture> pictures;
  std::vector<Panorama> panoramas;
  Pictures12() {
    for (std::uint64_t i = 0; i < 12; ++i) pictures.push_back(Boxes(i));
    for (const Picture& picture : pictures) panoramas.push_back(picture.panorama());
  }
};

ModelConfig Small(int rows = 32, DepthFusion depth = DepthFusion::kChannel) {
  ModelConfig config;
  config.depth = depth;
  config.width = 16;
  config.rows = rows;
  config.pair_features = 32;
  config.precision = Precision::kFloat32;
  return config;
}

QuantisedNet Quantised(const SemanticNet& net, const Pictures12& pictures) {
  std::vector<torch::Tensor> inputs;
  for (const Panorama& panorama : pictures.panoramas) {
    inputs.push_back(PrepareInput(net.config(), panorama));
  }
  return Quantise(net, at::cat(inputs));
}

bool operator==(const PairPrediction& a, const PairPrediction& b) {
  return a.same_node == b.same_node && a.direction == b.direction && a.distance == b.distance &&
         a.score == b.score;
}

std::vector<const PanoramaCode*> PointersTo(const std::vector<PanoramaCode>& codes) {
  std::vector<const PanoramaCode*> pointers;
  for (const PanoramaCode& code : codes) pointers.push_back(&code);
  return pointers;
}

/// Root of the mean squared difference of numbers.
class Difference {
 public:
  template <class A, class B>
  void Add(const A& a, const B& b) {
    for (std::size_t i = 0; i < a.size(); ++i) Add(a[i], b[i]);
  }
  void Add(float a, float b) {
    sum_ += (a - b) * (a - b);
    ++count_;
  }
  double root() const { return std::sqrt(sum_ / std::max(1, count_)); }

 private:
  double sum_ = 0.0;
  int count_ = 0;
};

class IntegerModelTest : public testing::Test {
 protected:
  std::filesystem::path Save(const ModelConfig& config) {
    SemanticNet net(config, 3);
    const auto file = folder_.path() / "both.safetensors";
    SaveNet(net, {}, StoredType::kFloat32, file);
    TensorFile content = ReadTensorFile(file);
    SetQuantised(Quantised(net, pictures_), &content);
    WriteTensorFile(file, content);
    return file;
  }

  Pictures12 pictures_;
  tests::TemporaryFolder folder_;
};

/// How far the integers of a file are from its trained network, at most.
void ExpectAgreement(const std::filesystem::path& file, const std::vector<Panorama>& panoramas,
                     double largest) {
  LearnedModel trained(file, Rig{});
  const auto integers = LoadIntegerModel(file, Rig{});
  const auto codes = trained.Encode(panoramas);
  const auto integer_codes = integers->Encode(panoramas);
  Difference explorable;
  for (std::size_t i = 0; i < codes.size(); ++i) {
    explorable.Add(trained.Explorable(codes[i]), integers->Explorable(integer_codes[i]));
  }
  EXPECT_LT(explorable.root(), largest);
  Difference same;
  Difference distance;
  Difference direction;
  Difference score;
  for (std::size_t goal = 0; goal < codes.size(); ++goal) {
    const auto said = trained.Compare(PointersTo(codes), codes[goal]);
    const auto integers_said = integers->Compare(PointersTo(integer_codes), integer_codes[goal]);
    for (std::size_t i = 0; i < said.size(); ++i) {
      same.Add(said[i].same_node, integers_said[i].same_node);
      distance.Add(said[i].distance, integers_said[i].distance);
      direction.Add(said[i].direction, integers_said[i].direction);
      score.Add(said[i].score, integers_said[i].score);
    }
  }
  EXPECT_LT(same.root(), largest);
  EXPECT_LT(distance.root(), kNodeRadius * largest);
  EXPECT_LT(direction.root(), largest);
  EXPECT_LT(score.root(), largest);
}

TEST_F(IntegerModelTest, SaysWhatAnUntrainedOneSays) {
  for (const int rows : {32, 64}) {
    for (const DepthFusion depth : {DepthFusion::kChannel, DepthFusion::kNone}) {
      ExpectAgreement(Save(Small(rows, depth)), pictures_.panoramas, 0.05);
    }
  }
}

TEST_F(IntegerModelTest, SaysWhatTheShippedOneSays) {
  const auto file = folder_.path() / "both.safetensors";
  const std::filesystem::path weights =
      std::filesystem::path(BULLETNAV_SOURCE_DIR) / "assets/weights/nts_rgbd.safetensors";
  TensorFile content = ReadTensorFile(weights);
  SetQuantised(Quantised(*LoadNet(weights), pictures_), &content);
  WriteTensorFile(file, content);
  ExpectAgreement(file, pictures_.panoramas, 0.02);
}

TEST_F(IntegerModelTest, IsTheSameToTheBitWithAllKernelsAndTogether) {
  SemanticNet net(Small(), 3);
  const QuantisedNet quantised = Quantised(net, pictures_);
  IntegerModel first(quantised, 32, true);
  const auto codes = first.Encode(pictures_.panoramas);
  const auto said = first.Compare(PointersTo(codes), codes[1]);
  EXPECT_NE(codes[0], codes[1]);
  for (const IntegerKernels* kernels : SupportedIntegerKernels()) {
    IntegerModel model(quantised, 32, true);
    model.Use(*kernels);
    for (std::size_t i = 0; i < codes.size(); ++i) {
      EXPECT_EQ(model.Encode(std::span(pictures_.panoramas).subspan(i, 1)).front(), codes[i])
          << kernels->name;
      const std::vector<const PanoramaCode*> one = {&codes[i]};
      EXPECT_TRUE(model.Compare(one, codes[1]).front() == said[i]) << kernels->name;
    }
  }
}

TEST_F(IntegerModelTest, WhatIsExpectedIsEncodedTogetherAndNothingElseChanges) {
  SemanticNet net(Small(), 3);
  IntegerModel model(Quantised(net, pictures_), 32, true);
  const auto codes = model.Encode(pictures_.panoramas);
  const auto ask = [&](std::size_t i) {
    return model.Encode(std::span(pictures_.panoramas).subspan(i, 1)).front();
  };
  model.Expect(std::span(pictures_.panoramas).first(3));
  EXPECT_EQ(ask(1), codes[1]);
  // Those that it was told of were taken then: what their memory holds now is not looked at.
  std::fill(pictures_.pictures[0].color.begin(), pictures_.pictures[0].color.end(), 0);
  EXPECT_EQ(ask(0), codes[0]);
  EXPECT_EQ(ask(5), codes[5]);
  model.Expect({});
  EXPECT_NE(ask(0), codes[0]);
}

TEST_F(IntegerModelTest, AFileWithIntegersPlaysInIntegers) {
  const auto file = Save(Small());
  EXPECT_TRUE(HoldsIntegers(ReadTensorFile(file)));
  EXPECT_NE(std::dynamic_pointer_cast<IntegerModel>(LoadModel(file, Rig{})), nullptr);
  // The trained weights are still there, alone.
  const auto net = LoadNet(file);
  SaveNet(*net, {}, StoredType::kFloat32, file);
  EXPECT_FALSE(HoldsIntegers(ReadTensorFile(file)));
  EXPECT_NE(std::dynamic_pointer_cast<LearnedModel>(LoadModel(file, Rig{})), nullptr);
  EXPECT_THROW(LoadIntegerModel(file, Rig{}), sim::FileError);
}

TEST_F(IntegerModelTest, IntegersAloneActTheSameAndAreNotTrainedOn) {
  const auto file = Save(Small());
  const auto alone = folder_.path() / "alone.safetensors";
  KeepIntegersAlone(file, alone);
  EXPECT_LT(std::filesystem::file_size(alone), std::filesystem::file_size(file) / 2);
  const TensorFile content = ReadTensorFile(alone);
  EXPECT_EQ(ReadQuantised(content, alone), ReadQuantised(ReadTensorFile(file), file));
  EXPECT_NE(std::dynamic_pointer_cast<IntegerModel>(LoadModel(alone, Rig{})), nullptr);
  EXPECT_THROW(LoadNet(alone), sim::FileError);
  SaveNet(SemanticNet(Small(), 3), {}, StoredType::kFloat32, file);
  EXPECT_THROW(KeepIntegersAlone(file, alone), sim::FileError);
}

TEST_F(IntegerModelTest, IntegersAloneActTheSameWhereTheTrainedWeightsAreShort) {
  SemanticNet net(Small(), 3);
  const QuantisedNet quantised = Quantised(net, pictures_);
  const auto file = folder_.path() / "short.safetensors";
  SaveNet(net, {}, StoredType::kBfloat16, file);
  AddQuantised(quantised, file, file);
  KeepIntegersAlone(file, file);
  EXPECT_EQ(ReadQuantised(ReadTensorFile(file), file), quantised);
}

TEST_F(IntegerModelTest, FilesKeepIntegersAsTheyAre) {
  SemanticNet net(Small(), 3);
  const QuantisedNet quantised = Quantised(net, pictures_);
  TensorFile content;
  SetQuantised(quantised, &content);
  const auto file = folder_.path() / "w.safetensors";
  WriteTensorFile(file, content, StoredType::kBfloat16);
  EXPECT_EQ(ReadQuantised(ReadTensorFile(file), file), quantised);
}

TEST_F(IntegerModelTest, RefusesDamagedFiles) {
  const auto file = Save(Small());
  const TensorFile good = ReadTensorFile(file);
  const auto expect_refused = [&](const auto& damage) {
    TensorFile bad = good;
    damage(&bad);
    WriteTensorFile(file, bad);
    EXPECT_THROW(LoadIntegerModel(file, Rig{}), sim::FileError);
  };
  std::size_t number = 0;
  for (const auto& [name, tensor] : good.tensors) {
    if (!name.starts_with(kIntegerPrefix) || number++ % 11 != 0) continue;
    // A shortcut's weights alone: then there is no shortcut, and sizes do not fit.
    expect_refused([&](TensorFile* bad) {
      bad->tensors.erase(name);
    });
  }
  const std::string stem = "integer.encoder.trunk.stem";
  expect_refused([&](TensorFile* bad) {
    bad->tensors[stem + ".scale"].values[1] = NAN;
  });
  expect_refused([&](TensorFile* bad) {
    bad->tensors[stem + ".scale"].values[1] = 0.0f;
  });
  expect_refused([&](TensorFile* bad) {
    bad->tensors[stem + ".scale"].values[1] = 1e30f;
  });
  expect_refused([&](TensorFile* bad) {
    bad->tensors[stem + ".weight"].values[1] = 100.0f;
  });
  expect_refused([&](TensorFile* bad) {
    bad->tensors[stem + ".weight"].shape = {16 * 7, 28, 1};
  });
  expect_refused([&](TensorFile* bad) {
    bad->tensors[stem + ".step"].values[0] = -1.0f;
  });
  expect_refused([&](TensorFile* bad) {
    bad->tensors["integer.heads.product.step"].values[0] = 1e-30f;
  });
  expect_refused([&](TensorFile* bad) {
    std::fill(bad->tensors["integer.encoder.first.weight"].values.begin(),
              bad->tensors["integer.encoder.first.weight"].values.end(), 32767.0f);
  });
  WriteTensorFile(file, good);
  EXPECT_NO_THROW(LoadIntegerModel(file, Rig{}));
}

TEST_F(IntegerModelTest, RefusesFormsThatThereAreNoIntegersOf) {
  ModelConfig config = Small();
  config.encoder = EncoderForm::kPatches;
  SemanticNet patches(config, 1);
  EXPECT_THROW(Quantised(patches, pictures_), sim::Error);
  config = Small();
  config.depth = DepthFusion::kSeparate;
  SemanticNet separate(config, 1);
  EXPECT_THROW(Quantised(separate, pictures_), sim::Error);
}

TEST(IntegerInput, IsThatOfFloatsInSteps) {
  for (const int rows : {32, 64, 128}) {
    Picture picture = Boxes(7);
    const torch::Tensor expected = PrepareInput(Small(rows), picture.panorama());
    Pictures pictures({rows, 4 * rows, kInputChannels, kStemBorder}, 2, kInputZero);
    IntegerInput(rows, true).Prepare(picture.panorama(), 1, &pictures);
    for (int row = 0; row < rows; ++row) {
      for (int col = 0; col < 4 * rows; ++col) {
        for (int c = 0; c < 4; ++c) {
          const int at = pictures.shape.size() + pictures.shape.Offset(row, col) + c;
          const int steps = pictures.bytes[static_cast<std::size_t>(at)] - kInputZero;
          const double step = (c < 3 ? 4.0 : 2.0) / 254.0;
          ASSERT_NEAR(expected[0][c][row][col].item<float>(), steps * step, 0.6 * step);
        }
      }
    }
  }
}

TEST(IntegerInput, DepthsThatAreNoNumbersAreNothing) {
  Picture picture = Boxes(7);
  std::fill(picture.depth.begin(), picture.depth.end(), std::numeric_limits<float>::quiet_NaN());
  Pictures pictures({128, 512, kInputChannels, kStemBorder}, 1, kInputZero);
  IntegerInput(128, true).Prepare(picture.panorama(), 0, &pictures);
  EXPECT_EQ(pictures.bytes[static_cast<std::size_t>(pictures.shape.Offset(3, 4) + 3)], 0);
  std::fill(picture.depth.begin(), picture.depth.end(), std::numeric_limits<float>::infinity());
  IntegerInput(128, true).Prepare(picture.panorama(), 0, &pictures);
  EXPECT_EQ(pictures.bytes[static_cast<std::size_t>(pictures.shape.Offset(3, 4) + 3)], 254);
}

}  // namespace
}  // namespace bulletnav::agent
