// SPDX-License-Identifier: MIT
#include "agent/perception/mapper_net.h"

#include <cmath>

#include "agent/models/free_space_model.h"
#include "agent/perception/encoder.h"
#include "agent/perception/model_file.h"
#include "agent/perception/weights.h"
#include "sim/base/elementary.h"
#include "sim/config/yaml_writer.h"
#include "sim/math/pose.h"

namespace bulletnav::agent {
namespace {

constexpr int kRanges = 64;     // along a ray, 5 cm each
constexpr int kBearings = 256;  // around the ring
constexpr int kStride = 4;      // pixels a column of stage one
constexpr std::array<std::size_t, 3> kStages = {0, 1, 3};
constexpr double kOutputGain = 0.1;  // first answers are undecided

/// [to, from]: columns of a coarse ring for those of a finer one. Column j of either is centred at
/// the same bearing as pixel j times its stride.
torch::Tensor SpreadShares(int to, int from) {
  torch::Tensor shares = torch::zeros({to, from});
  auto share = shares.accessor<float, 2>();
  const int times = to / from;
  for (int column = 0; column < to; ++column) {
    const float next = static_cast<float>(column % times) / static_cast<float>(times);
    share[column][column / times] += 1.0f - next;
    share[column][(column / times + 1) % from] += next;
  }
  return shares;
}

/// Where on the ring of kRanges x (kBearings + 2), its ends continued by one bearing, the middles
/// of the map's cells lie; as grid_sampler counts, from -1 to 1. Pixel p of a row of `cols` looks
/// at bearing pi - 2 pi (p + 1/2) / cols.
torch::Tensor CellsOnRing(int cols) {
  constexpr int kSide = FreeSpace::kSide;
  torch::Tensor places = torch::empty({1, kSide, kSide, 2});
  auto place = places.accessor<float, 4>();
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const FreeSpace::Place at = FreeSpace::CentreOf({x, y});
      const double range = std::hypot(at.x, at.y) / FreeSpace::kReach * kRanges - 0.5;
      const double pixel = cols * (0.5 - sim::Atan2(at.y, at.x) / (2.0 * sim::kPi)) - 0.5;
      // The first column of stage one looks from half its width before pixel 0 to half behind.
      const double bearing = (pixel + 0.5 * kStride) * kBearings / cols - 0.5;
      const double wrapped = bearing - kBearings * std::floor((bearing + 0.5) / kBearings);
      place[0][y][x][0] = static_cast<float>(2.0 * (wrapped + 1.0) / (kBearings + 1) - 1.0);
      place[0][y][x][1] = static_cast<float>(2.0 * range / (kRanges - 1) - 1.0);
    }
  }
  return places;
}

/// [n, channels, rows, cols] to [n, cols, rows * channels].
torch::Tensor Flat(const torch::Tensor& stage) {
  return stage.permute({0, 3, 2, 1})
      .reshape({stage.size(0), stage.size(3), stage.size(2) * stage.size(1)})
      .to(torch::kFloat32);
}

}  // namespace

MapperNet::MapperNet(const MapperConfig& config, std::uint64_t seed) : config_(config) {
  sim::Rng rng(seed, "mapper_net");
  const Trunk::Shape shape = TrunkShape(config.seeing(), 3);
  trunk_ = register_module("trunk", std::make_shared<Trunk>(shape, &rng));
  const int columns = config.seeing().cols() / kStride;
  int rows = config.rows / kStride;
  int cols = columns;
  std::size_t level = 0;
  for (int stage = 0; stage < 4; ++stage) {
    if (stage > 0 && stage <= shape.halvings) {
      rows /= 2;
      cols /= 2;
    }
    if (stage != static_cast<int>(kStages[level])) continue;
    levels_[level] = register_module(
        "level" + std::to_string(stage + 1),
        std::make_shared<Dense>(rows * (config.width << stage), config.features, &rng));
    spread_[level] = SpreadShares(columns, cols);
    ++level;
  }
  hidden_ =
      register_module("hidden", std::make_shared<Dense>(config.features, config.features, &rng));
  rays_ = register_module(
      "rays", std::make_shared<Dense>(config.features, 2 * kRanges * kBearings / columns, &rng,
                                      kOutputGain));
  cells_ = CellsOnRing(config.seeing().cols());
}

torch::Tensor MapperNet::Columns(const torch::Tensor& input) {
  const std::vector<torch::Tensor> stages = trunk_->Stages(input.to(ComputeType(config_.seeing())));
  torch::Tensor sum = levels_[0]->forward(Flat(stages[kStages[0]]));
  for (std::size_t i = 1; i < kLevels; ++i) {
    const torch::Tensor coarse = levels_[i]->forward(Flat(stages[kStages[i]]));
    sum = sum + at::matmul(spread_[i].to(coarse.device()), coarse);
  }
  return sum;
}

torch::Tensor MapperNet::forward(const torch::Tensor& input, std::optional<at::Generator> dropout) {
  const torch::Tensor columns = Dropout(Columns(input).relu(), config_.dropout, dropout);
  const torch::Tensor hidden = Dropout(hidden_->forward(columns).relu(), config_.dropout, dropout);
  const std::int64_t count = input.size(0);
  // [n, columns, bearings in a column, channel, range] to [n, channel, range, bearing].
  const torch::Tensor ring =
      rays_->forward(hidden).view({count, kBearings, 2, kRanges}).permute({0, 2, 3, 1});
  const torch::Tensor closed =
      at::cat({ring.narrow(3, kBearings - 1, 1), ring, ring.narrow(3, 0, 1)}, 3);
  const torch::Tensor cells =
      cells_.to(closed.device()).expand({count, FreeSpace::kSide, FreeSpace::kSide, 2});
  constexpr int kBilinear = 0;
  constexpr int kBorder = 1;
  return at::grid_sampler_2d(closed, cells, kBilinear, kBorder, true);
}

void MapperNet::Fold() {
  trunk_->Fold(ComputeType(config_.seeing()));
}

void SaveMapper(const MapperNet& net, std::map<std::string, std::string> notes, StoredType type,
                const std::filesystem::path& file) {
  notes[kMapperKey] = sim::ToYaml(net.config());
  SaveWeights(net, std::move(notes), type, file);
}

std::shared_ptr<MapperNet> LoadMapper(const std::filesystem::path& file) {
  const TensorFile content = ReadTensorFile(file);
  auto net = std::make_shared<MapperNet>(MapperConfigOf(content, file), 0);
  SetWeights(content, "", file, net.get());
  return net;
}

void TakeMapper(const std::filesystem::path& file, MapperNet* net) {
  const TensorFile content = ReadTensorFile(file);
  MapperConfig theirs = MapperConfigOf(content, file);
  theirs.dropout = net->config().dropout;
  theirs.precision = net->config().precision;
  if (theirs != net->config()) throw OtherShape(file, kMapperKey);
  SetWeights(content, "", file, net);
}

}  // namespace bulletnav::agent
