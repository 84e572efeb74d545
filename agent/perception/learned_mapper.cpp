// SPDX-License-Identifier: MIT
#include "agent/perception/learned_mapper.h"

#include "agent/models/model_registry.h"
#include "agent/perception/encoder.h"
#include "agent/perception/mapper_net.h"
#include "agent/perception/model_file.h"
#include "agent/perception/one_thread.h"
#include "sim/base/check.h"

namespace bulletnav::agent {
namespace {

sim::Grid<float> ToGrid(const torch::Tensor& map) {
  sim::Grid<float> grid(FreeSpace::kSide);
  BULLETNAV_CHECK_EQ(static_cast<std::size_t>(map.numel()), grid.values().size());
  const torch::Tensor flat = map.contiguous();
  const float* values = flat.data_ptr<float>();
  for (std::size_t i = 0; i < grid.values().size(); ++i) grid[i] = values[i];
  return grid;
}

}  // namespace

class LearnedMapper::Impl {
 public:
  Impl(const std::filesystem::path& weights, const Rig& rig) : net_(LoadMapper(weights)) {
    RequireRig(rig, net_->config().seeing(), weights);
    net_->eval();
    net_->Fold();
  }

  FreeSpace Predict(const Panorama& panorama) {
    const c10::InferenceMode inference;
    StayInThisThread();
    const torch::Tensor input = PrepareInput(net_->config().seeing(), panorama);
    const torch::Tensor map = net_->forward(input).sigmoid();
    FreeSpace space;
    space.explored = ToGrid(map.select(1, 0));
    space.obstacle = ToGrid(map.select(1, 1));
    return space;
  }

 private:
  std::shared_ptr<MapperNet> net_;
};

LearnedMapper::LearnedMapper(const std::filesystem::path& weights, const Rig& rig)
    : impl_(std::make_unique<Impl>(weights, rig)) {}

LearnedMapper::~LearnedMapper() = default;

FreeSpace LearnedMapper::Predict(const Panorama& panorama) {
  return impl_->Predict(panorama);
}

namespace {

const ModelRegistration registration(kMapperKey,
                                     [](const std::filesystem::path& weights, const Rig& rig) {
                                       return std::make_shared<LearnedMapper>(weights, rig);
                                     });

}  // namespace

}  // namespace bulletnav::agent
