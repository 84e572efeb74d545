// SPDX-License-Identifier: MIT
#include "agent/integer/integer_mapper.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "agent/integer/quantised_file.h"
#include "agent/models/model_registry.h"
#include "agent/perception/encoder.h"
#include "agent/perception/integer_models.h"
#include "agent/perception/learned_mapper.h"
#include "agent/perception/model_file.h"
#include "agent/perception/quantise.h"
#include "sim/base/error.h"
#include "sim/math/rng.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::agent {
namespace {

using Color = std::vector<std::uint8_t>;

/// Coloured stripes and boxes.
Color Boxes(std::uint64_t seed) {
  sim::Rng rng(seed, "boxes");
  Color color(std::size_t{128} * 512 * 3);
  for (int box = 0; box < 60; ++box) {
    const int top = rng.Between(0, 100);
    const int left = rng.Between(0, 450);
    const int paint = rng.Between(0, 0xffffff);
    for (int i = 0; i < 50 * 80; ++i) {
      const int row = std::min(127, top + i / 80);
      const int col = std::min(511, left + i % 80);
      for (int c = 0; c < 3; ++c) {
        color[static_cast<std::size_t>(3 * (row * 512 + col) + c)] =
            static_cast<std::uint8_t>(paint >> (8 * c));
      }
    }
  }
  return color;
}

Rig ColorRig() {
  Rig rig;
  rig.has_depth = false;
  return rig;
}

double RootOfMeanSquare(const sim::Grid<float>& a, const sim::Grid<float>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.values().size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum / static_cast<double>(a.values().size()));
}

class IntegerMapperTest : public testing::Test {
 protected:
  QuantisedNet Quantised(const MapperNet& net) const {
    std::vector<torch::Tensor> inputs;
    for (std::uint64_t i = 0; i < 4; ++i) {
      const Color color = Boxes(i);
      inputs.push_back(PrepareInput(net.config().seeing(), Panorama{color, {}}));
    }
    return Quantise(net, at::cat(inputs));
  }

  std::filesystem::path Save(const MapperNet& net) const {
    const auto file = folder_.path() / "both.safetensors";
    SaveMapper(net, {}, StoredType::kFloat32, file);
    TensorFile content = ReadTensorFile(file);
    SetQuantised(Quantised(net), &content);
    WriteTensorFile(file, content);
    return file;
  }

  static MapperConfig Small(int rows) {
    MapperConfig config;
    config.width = 16;
    config.rows = rows;
    config.features = 32;
    config.precision = Precision::kFloat32;
    return config;
  }

  tests::TemporaryFolder folder_;
};

void ExpectAgreement(const std::filesystem::path& file, double largest) {
  LearnedMapper trained(file, ColorRig());
  const auto integers = LoadIntegerMapper(file, ColorRig());
  for (std::uint64_t i = 2; i < 6; ++i) {
    const Color color = Boxes(i);
    const FreeSpace expected = trained.Predict({color, {}});
    const FreeSpace said = integers->Predict({color, {}});
    EXPECT_LT(RootOfMeanSquare(said.explored, expected.explored), largest);
    EXPECT_LT(RootOfMeanSquare(said.obstacle, expected.obstacle), largest);
  }
}

TEST_F(IntegerMapperTest, SaysWhatAnUntrainedOneSays) {
  for (const int rows : {32, 64, 128}) ExpectAgreement(Save(MapperNet(Small(rows), 3)), 0.03);
}

TEST_F(IntegerMapperTest, SaysWhatTheShippedOneSays) {
  const auto net = LoadMapper(std::filesystem::path(BULLETNAV_SOURCE_DIR) /
                              "assets/weights/mapper_rgb.safetensors");
  ExpectAgreement(Save(*net), 0.05);
}

TEST_F(IntegerMapperTest, IsTheSameToTheBitWithAllKernels) {
  const QuantisedNet net = Quantised(MapperNet(Small(64), 3));
  const Color color = Boxes(9);
  const FreeSpace expected = IntegerMapper(net, 64).Predict({color, {}});
  for (const IntegerKernels* kernels : SupportedIntegerKernels()) {
    IntegerMapper mapper(net, 64);
    mapper.Use(*kernels);
    const FreeSpace said = mapper.Predict({color, {}});
    EXPECT_EQ(said.explored.values(), expected.explored.values()) << kernels->name;
    EXPECT_EQ(said.obstacle.values(), expected.obstacle.values()) << kernels->name;
  }
}

TEST_F(IntegerMapperTest, AFileWithIntegersPlaysInIntegers) {
  const auto file = Save(MapperNet(Small(32), 3));
  EXPECT_NE(std::dynamic_pointer_cast<IntegerMapper>(LoadModel(file, ColorRig())), nullptr);
  TensorFile bad = ReadTensorFile(file);
  bad.tensors["integer.rays.step"] = bad.tensors["integer.hidden.step"];
  bad.tensors["integer.hidden.step"].values[0] = 0.0f;
  WriteTensorFile(file, bad);
  EXPECT_THROW(LoadModel(file, ColorRig()), sim::FileError);
}

TEST(PlacesOnRing, DoNotDependOnLastBits) {
  // Roundings of the same angles in higher precision, and how far they are from the nearest tie.
  for (const int cols : {128, 256, 512}) {
    const std::vector<RingPlace> places = PlacesOnRing(cols);
    for (int i = 0; i < 128 * 128; ++i) {
      const long double x = 2 * (i % 128) + 1 - 128;
      const long double y = 2 * (i / 128) + 1 - 128;
      const long double turn = std::atan2(y, x) / (2.0L * 3.14159265358979323846264338327950288L);
      const long double pixel = static_cast<long double>(cols) * (0.5L - turn) - 0.5L;
      const long double steps =
          256.0L * ((pixel + 2.0L) * 256.0L / static_cast<long double>(cols) - 0.5L + 256.0L);
      const long double nearest = std::floor(steps + 0.5L);
      EXPECT_LT(std::abs(steps - nearest), 0.5L - 1e-9L);
      const RingPlace& place = places[static_cast<std::size_t>(i)];
      EXPECT_EQ(static_cast<int>(nearest) % 65536, place.bearing * 256 + place.bearing_share);
    }
  }
}

}  // namespace
}  // namespace bulletnav::agent
