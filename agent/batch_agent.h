// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "agent/agent.h"

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

/// One plain agent a lane.
class LaneAgents final : public BatchAgent {
 public:
  explicit LaneAgents(std::vector<std::unique_ptr<Agent>> agents) : agents_(std::move(agents)) {}

  int lanes() const override { return static_cast<int>(agents_.size()); }
  void Reset(int lane, const Panorama& goal, std::uint64_t seed) override {
    agent(lane).Reset(goal, seed);
  }
  void NextGoal(int lane, const Panorama& goal, std::uint64_t seed) override {
    agent(lane).NextGoal(goal, seed);
  }
  void Act(std::span<const LaneObservation> observations, std::span<sim::Action> actions) override {
    for (std::size_t i = 0; i < observations.size(); ++i) {
      actions[i] = agent(observations[i].lane).Act(observations[i].observation);
    }
  }

  Belief belief(int lane) const override {
    return agents_.at(static_cast<std::size_t>(lane))->belief();
  }

 private:
  Agent& agent(int lane) { return *agents_.at(static_cast<std::size_t>(lane)); }

  std::vector<std::unique_ptr<Agent>> agents_;
};

}  // namespace bulletnav::agent
