// SPDX-License-Identifier: MIT
#include "benchmark/training/rl/navigation/lane_training.h"

#include <numeric>

namespace bulletnav::bench {

LaneTraining::LaneTraining(const NavigationPlan& plan, const Shape& shape,
                           const TrainContext& context)
    : setting_(plan.setting),
      shape_(shape),
      peers_(context.peers),
      world_(plan, {Share().lanes, shape.rollout}, context),
      pool_(peers_ ? peers_->threads() : 0) {}

void LaneTraining::TakeNet(const std::function<std::unique_ptr<PictureNet>()>& make) {
  net_ = make();
  groups_ = std::make_unique<LaneGroups>(shape_.lanes, shape_.group, make, net_.get(), &pool_,
                                         peers_.get());
}

void LaneTraining::TakeLanes(const NavigationSpec& spec, ActorCritic* player, std::uint64_t seed) {
  lanes_ = std::make_unique<NavigationLanes>(spec, world_.scenes(), &pool_);
  actor_ = std::make_unique<Actor>(lanes_.get(), player, &pool_, shape_.group, seed);
}

std::vector<int> LaneTraining::AllGroups() const {
  std::vector<int> all(static_cast<std::size_t>(groups_->groups()));
  std::iota(all.begin(), all.end(), 0);
  return all;
}

Measures LaneTraining::Validate() {
  Measures measures = world_.Validate(net_->policy(), &pool_);
  AppendLearned(&measures);
  return measures;
}

std::optional<Measures> LaneTraining::Quantise(const std::filesystem::path& file) {
  std::optional<Measures> measures = world_.Quantise(net_->policy().get(), file, &pool_);
  if (measures) AppendLearned(&*measures);
  return measures;
}

void LaneTraining::Save(std::map<std::string, std::string> notes,
                        const std::filesystem::path& file) const {
  agent::SavePolicy(*net_->policy(), std::move(notes), agent::StoredType::kBfloat16, file);
}

void LaneTraining::AppendState(agent::TensorFile* content) const {
  AppendLanes(Ref(), content);
}

void LaneTraining::SetState(const agent::TensorFile& content, const std::filesystem::path& file) {
  SetLanes(content, file, Ref());
}

}  // namespace bulletnav::bench
