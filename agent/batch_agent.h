// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "agent/agent.h"
#include "agent/models/encodes_together.h"

namespace bulletnav::agent {

/// What one of several bodies saw.
struct LaneObservation {
  int lane = 0;
  Observation observation;
};

/// Steers several bodies ("lanes") in episodes of their own, so that a network can see all their
/// panoramas at once. Every runner works through this interface; a plain Agent is put behind it by
/// its registration. An agent X that batches derives from this class instead of Agent and is built
/// by X(const Config&, std::span<const AgentContext>), one context per lane.
/// A lane's actions must not depend on what other lanes see.
class BatchAgent {
 public:
  BatchAgent() = default;
  virtual ~BatchAgent() = default;
  BatchAgent(const BatchAgent&) = delete;
  BatchAgent& operator=(const BatchAgent&) = delete;
  BatchAgent(BatchAgent&&) = delete;
  BatchAgent& operator=(BatchAgent&&) = delete;

  virtual int lanes() const = 0;

  /// Agent::Reset and Agent::NextGoal of one lane.
  virtual void Reset(int lane, const Panorama& goal, std::uint64_t seed) = 0;
  virtual void NextGoal(int lane, const Panorama& goal, std::uint64_t seed) = 0;

  /// Writes actions[i] for observations[i]; lanes differ, not all need be there. After an exception
  /// the lanes named must be reset.
  virtual void Act(std::span<const LaneObservation> observations,
                   std::span<sim::Action> actions) = 0;

  virtual Belief belief(int /*lane*/) const { return {}; }
};

/// One plain agent a lane. Models that the lanes share are told what they will be asked for.
class LaneAgents final : public BatchAgent {
 public:
  explicit LaneAgents(std::vector<std::unique_ptr<Agent>> agents,
                      std::vector<std::shared_ptr<EncodesTogether>> models = {})
      : agents_(std::move(agents)), models_(std::move(models)) {}

  int lanes() const override { return static_cast<int>(agents_.size()); }
  void Reset(int lane, const Panorama& goal, std::uint64_t seed) override {
    agent(lane).Reset(goal, seed);
  }
  void NextGoal(int lane, const Panorama& goal, std::uint64_t seed) override {
    agent(lane).NextGoal(goal, seed);
  }
  void Act(std::span<const LaneObservation> observations, std::span<sim::Action> actions) override {
    const Expected expected(models_, observations);
    for (std::size_t i = 0; i < observations.size(); ++i) {
      actions[i] = agent(observations[i].lane).Act(observations[i].observation);
    }
  }

  Belief belief(int lane) const override {
    return agents_.at(static_cast<std::size_t>(lane))->belief();
  }

 private:
  /// While a step is decided: panoramas change with the next one.
  class Expected {
   public:
    Expected(const std::vector<std::shared_ptr<EncodesTogether>>& models,
             std::span<const LaneObservation> observations)
        : models_(models) {
      if (models_.empty() || observations.size() < 2) return;
      std::vector<Panorama> panoramas;
      panoramas.reserve(observations.size());
      for (const LaneObservation& one : observations) {
        panoramas.push_back(one.observation.panorama);
      }
      for (const auto& model : models_) model->Expect(panoramas);
    }
    ~Expected() {
      for (const auto& model : models_) model->Expect({});
    }
    Expected(const Expected&) = delete;
    Expected& operator=(const Expected&) = delete;
    Expected(Expected&&) = delete;
    Expected& operator=(Expected&&) = delete;

   private:
    const std::vector<std::shared_ptr<EncodesTogether>>& models_;
  };

  Agent& agent(int lane) { return *agents_.at(static_cast<std::size_t>(lane)); }

  std::vector<std::unique_ptr<Agent>> agents_;
  std::vector<std::shared_ptr<EncodesTogether>> models_;
};

}  // namespace bulletnav::agent
