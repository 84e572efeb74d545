// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "benchmark/training/core/training.h"
#include "benchmark/training/rl/lanes_state.h"
#include "benchmark/training/rl/navigation/navigation_plan.h"

namespace bulletnav::bench {

/// What trainings of a policy in lanes have in common, where what is learned comes without reward:
/// the world, who plays, and how they are kept and told. See PpoTraining for those with reward.
class LaneTraining : public Training {
 public:
  torch::nn::Module& net() override { return *net_; }
  bool shares_work() const override { return true; }
  std::int64_t FramesAfter(int steps) const override {
    return std::int64_t{steps} * shape_.lanes * shape_.rollout;
  }
  std::int64_t FramesBefore() const override { return world_.frames_before(); }
  void Save(std::map<std::string, std::string> notes,
            const std::filesystem::path& file) const override;
  Measures Validate() override;
  std::optional<Measures> Quantise(const std::filesystem::path& file) override;
  void AppendState(agent::TensorFile* content) const override;
  void SetState(const agent::TensorFile& content, const std::filesystem::path& file) override;
  std::string Describe(const Measures& measures) const override {
    return DescribeNavigation(measures);
  }
  std::string curves_label() const override { return "success, validation"; }
  std::vector<CurveLine> curves() const override { return NavigationCurves(setting_); }
  std::vector<std::pair<std::string, std::string>> CardRows() const override {
    return world_.CardRows(shape_.lanes, shape_.rollout);
  }
  std::string validated_on() const override { return world_.validated_on(); }

 protected:
  struct Shape {
    int lanes = 0;    // of all processes
    int group = 0;    // lanes that are learned from together
    int rollout = 0;  // steps of each lane in a step of the training
    int minibatches = 1;
  };
  LaneTraining(const NavigationPlan& plan, const Shape& shape, const TrainContext& context);

  /// Who is trained and where; once, in the constructor. `make`: always the same net.
  void TakeNet(const std::function<std::unique_ptr<PictureNet>()>& make);
  /// `player`: who acts; must be there as long as something is learned.
  void TakeLanes(const NavigationSpec& spec, ActorCritic* player, std::uint64_t seed);
  LaneShare Share() const {
    return ShareOf(shape_.lanes, shape_.group, shape_.minibatches, peers_.get());
  }
  std::vector<int> AllGroups() const;
  /// What it has learned of late, after what Validate and Quantise say.
  virtual void AppendLearned(Measures* measures) const = 0;

  PictureNet* picture_net() { return net_.get(); }
  NavigationLanes* lanes() { return lanes_.get(); }
  LaneGroups* groups() { return groups_.get(); }
  Actor* actor() { return actor_.get(); }

 private:
  LanesRef Ref() const { return {lanes_.get(), actor_.get(), peers_.get()}; }

  LaneSetting setting_;
  Shape shape_;
  std::shared_ptr<Peers> peers_;  // or null
  NavigationWorld world_;
  sim::WorkerPool pool_;
  std::unique_ptr<PictureNet> net_;
  std::unique_ptr<NavigationLanes> lanes_;
  std::unique_ptr<LaneGroups> groups_;
  std::unique_ptr<Actor> actor_;
};

}  // namespace bulletnav::bench
