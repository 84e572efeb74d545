// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <memory>

#include "agent/belief.h"
#include "agent/models/model_slot.h"
#include "agent/observation.h"
#include "sim/base/action.h"

namespace bulletnav::agent {

/// What an agent is built with, besides its own config.
struct AgentContext {
  Rig rig;
  Models models = {};  // those of the agent's slots that are filled
};

/// Finds the place where the goal's panorama was taken. Sees observations and nothing else: no true
/// pose, no scene, no navmesh.
/// An agent X has `static constexpr std::string_view kName`, a nested struct `Config` (see
/// YamlReader) and a constructor X(const Config&, const AgentContext&), which throws Error if it
/// cannot work with the context. One that can be given models says which by
///   static std::vector<ModelSlot> ModelSlots(const Rig& rig);
/// It is one file in agent/baselines/ that ends in
///   const AgentRegistration<X> registration;
/// Deterministic: what it does is a function of config, context, goal, seed and observations.
class Agent {
 public:
  Agent() = default;
  virtual ~Agent() = default;
  Agent(const Agent&) = delete;
  Agent& operator=(const Agent&) = delete;
  Agent(Agent&&) = delete;
  Agent& operator=(Agent&&) = delete;

  /// Starts an episode and forgets all others. The goal's panorama lives until the next call of
  /// Reset or NextGoal.
  virtual void Reset(const Panorama& goal, std::uint64_t seed) = 0;

  /// Another goal in the same place, from where the body now is; steps count on from there. Agents
  /// that remember the place override this; others start afresh.
  virtual void NextGoal(const Panorama& goal, std::uint64_t seed) { Reset(goal, seed); }

  /// The next action. The first observation after Reset has zero odometry.
  virtual sim::Action Act(const Observation& observation) = 0;

  /// For drawing; nothing unless overridden.
  virtual Belief belief() const { return {}; }
};

}  // namespace bulletnav::agent
