// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <memory>
#include <optional>

#include "agent/registry.h"
#include "benchmark/play/ground_truth.h"
#include "benchmark/privileged/privileged_agent.h"
#include "sim/simulator.h"

namespace bulletnav::tests {

/// A start and a goal, for trying agents without a runner.
struct Trial {
  sim::BodyPose start;
  sim::BodyPose goal;
  double geodesic = 0.0;
  sim::EpisodeKey key;
};

/// Draws trials between two geodesic distances on the largest island. Expects that there are some.
Trial DrawTrial(const std::shared_ptr<const sim::World>& world, double low, double high,
                sim::Rng* rng);

struct TrialResult {
  bool stopped = false;
  double distance_left = 0.0;  // geodesic
  double geodesic = 0.0;       // at the start
  double path_length = 0.0;
  int steps = 0;
  int collisions = 0;

  bool success() const { return stopped && distance_left < 1.0; }
  double spl() const { return success() ? geodesic / std::max(geodesic, path_length) : 0.0; }
};

/// Called after every step of a trial.
using TrialHook = std::function<void(const sim::Simulator&, const agent::BatchAgent&)>;

/// Runs an agent, with the oracle to recognise the goal, until it stops or 500 steps are over.
TrialResult RunTrial(sim::Simulator* simulator, const Trial& trial, const agent::AgentMaker& maker,
                     const TrialHook& hook = {});
TrialResult RunTrial(sim::SimulatedBody* body, const sim::BodySpec& spec,
                     const std::shared_ptr<const sim::World>& world, const Trial& trial,
                     bench::PrivilegedAgent* agent);

}  // namespace bulletnav::tests
