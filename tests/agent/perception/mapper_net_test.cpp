// SPDX-License-Identifier: MIT
#include "agent/perception/mapper_net.h"

#include <cmath>

#include <gmock/gmock.h>

#include "agent/models/free_space_model.h"
#include "agent/perception/encoder.h"
#include "agent/perception/model_file.h"
#include "agent/perception/semantic_net.h"
#include "agent/perception/weights.h"
#include "sim/base/error.h"
#include "sim/math/pose.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::agent {
namespace {

using ::testing::HasSubstr;

MapperConfig Tiny(int rows = 32) {
  MapperConfig config;
  config.width = 8;
  config.rows = rows;
  config.features = 32;
  config.precision = Precision::kFloat32;
  return config;
}

/// Noise, the same for the same seed.
torch::Tensor Noise(int count, std::uint64_t seed) {
  const at::Generator generator = at::detail::createCPUGenerator(seed);
  return torch::randint(0, 256, {count, 128, 512, 3}, generator, torch::kUInt8);
}

torch::Tensor Input(const MapperConfig& config, int count, std::uint64_t seed, int roll = 0) {
  return PrepareInput(config.seeing(), Noise(count, seed).roll(roll, 2), {});
}

class MapperRows : public testing::TestWithParam<int> {};

TEST_P(MapperRows, AnswersForEachCellOfEachPanorama) {
  const MapperConfig config = Tiny(GetParam());
  MapperNet net(config, 1);
  net.eval();
  const torch::Tensor both = net.forward(Input(config, 2, 7));
  EXPECT_EQ(both.sizes(), (std::vector<std::int64_t>{2, 2, 128, 128}));
  EXPECT_TRUE(both.isfinite().all().item<bool>());
}

// Column c of 512 looks at bearing pi - 2 pi (c + 1/2) / 512.
TEST_P(MapperRows, ACellIsToldFromTheColumnsThatLookAtIt) {
  constexpr int kStrips = 32;
  constexpr int kWidth = 512 / kStrips;
  const MapperConfig config = Tiny(GetParam());
  MapperNet net(config, 1);
  net.eval();
  const torch::NoGradGuard no_grad;
  const torch::Tensor plain = Noise(1, 7);
  const torch::Tensor before = net.forward(PrepareInput(config.seeing(), plain, {}));
  torch::Tensor changed = plain.repeat({kStrips, 1, 1, 1});
  for (int strip = 0; strip < kStrips; ++strip) {
    changed.select(0, strip).narrow(1, strip * kWidth, kWidth).fill_(127);
  }
  const torch::Tensor change =
      (net.forward(PrepareInput(config.seeing(), changed, {})) - before).square().sum(1);
  // Where what a strip changes lies, against where the strip looks; mean over strips and cells.
  double all = 0.0;
  double along = 0.0;
  double aside = 0.0;
  auto changes = change.accessor<float, 3>();
  for (int i = 0; i < kStrips * FreeSpace::kSide * FreeSpace::kSide; ++i) {
    const sim::Cell cell{i % FreeSpace::kSide, i / FreeSpace::kSide % FreeSpace::kSide};
    const int strip = i / (FreeSpace::kSide * FreeSpace::kSide);
    const FreeSpace::Place p = FreeSpace::CentreOf(cell);
    const double looks = sim::kPi * (1.0 - 2.0 * (strip + 0.5) / kStrips);
    const double off = std::atan2(p.y, p.x) - looks;
    const double pull = changes[strip][cell.y][cell.x];
    all += pull;
    along += pull * std::cos(off);
    aside += pull * std::sin(off);
  }
  EXPECT_GT(along / all, 0.5);
  EXPECT_NEAR(aside / all, 0.0, 0.05);
}

TEST_P(MapperRows, AQuarterTurnTurnsTheMap) {
  const MapperConfig config = Tiny(GetParam());
  MapperNet net(config, 1);
  net.eval();
  const torch::Tensor straight = net.forward(Input(config, 1, 7));
  // The body turns left, and what it sees moves right: what was at (x, y) is at (y, -x).
  const torch::Tensor turned = net.forward(Input(config, 1, 7, 128));
  const torch::Tensor expected = straight.transpose(2, 3).flip(2);
  EXPECT_LT((turned - expected).abs().max().item<double>(), 1e-3);
}

INSTANTIATE_TEST_SUITE_P(All, MapperRows, testing::Values(32, 64, 128));

TEST(MapperNet, SameSeedSameWeights) {
  TensorFile a;
  TensorFile b;
  TensorFile c;
  AppendWeights(MapperNet(Tiny(), 1), "", &a);
  AppendWeights(MapperNet(Tiny(), 1), "", &b);
  AppendWeights(MapperNet(Tiny(), 2), "", &c);
  EXPECT_EQ(a.tensors, b.tensors);
  EXPECT_NE(a.tensors, c.tensors);
}

TEST(MapperNet, FoldedAnswersAreTheSame) {
  MapperNet net(Tiny(), 1);
  const torch::Tensor input = Input(Tiny(), 1, 7);
  {
    const torch::NoGradGuard no_grad;
    for (int i = 0; i < 20; ++i) net.forward(input);  // moves the running means
  }
  net.eval();
  const torch::NoGradGuard no_grad;
  const torch::Tensor before = net.forward(input);
  net.Fold();
  EXPECT_LT((net.forward(input) - before).abs().max().item<double>(), 1e-4);
}

TEST(MapperNet, WeightsComeBackThroughAFile) {
  const tests::TemporaryFolder folder;
  const auto file = folder.path() / "mapper.safetensors";
  const MapperNet net(Tiny(), 3);
  SaveMapper(net, {{"note", "x"}}, StoredType::kFloat32, file);
  const auto read = LoadMapper(file);
  EXPECT_EQ(read->config(), net.config());
  TensorFile before;
  TensorFile after;
  AppendWeights(net, "", &before);
  AppendWeights(*read, "", &after);
  EXPECT_EQ(before.tensors, after.tensors);
}

std::string Complaint(const std::filesystem::path& file) {
  try {
    LoadMapper(file);
  } catch (const sim::FileError& e) {
    return e.what();
  }
  return "none";
}

TEST(MapperNet, RefusesOtherWeights) {
  const tests::TemporaryFolder folder;
  const auto file = folder.path() / "weights.safetensors";
  EXPECT_THAT(Complaint(file), HasSubstr("weights.safetensors"));
  ModelConfig semantic;
  semantic.width = 8;
  SaveNet(SemanticNet(semantic, 1), {}, StoredType::kFloat32, file);
  EXPECT_THAT(Complaint(file), HasSubstr("mapper"));
  SaveMapper(MapperNet(Tiny(), 1), {}, StoredType::kFloat32, file);
  TensorFile content = ReadTensorFile(file);
  content.tensors.erase(content.tensors.begin());
  WriteTensorFile(file, content);
  EXPECT_THAT(Complaint(file), HasSubstr("is missing"));
  content.metadata[kMapperKey] = "width: 9";
  WriteTensorFile(file, content);
  EXPECT_THAT(Complaint(file), HasSubstr("width"));
}

}  // namespace
}  // namespace bulletnav::agent
