// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <memory>
#include <string>

#include "benchmark/play/trajectory.h"
#include "sim/simulator.h"
#include "tests/support/trials.h"

namespace bulletnav::tests {

/// Runs a privileged agent on a trial until it stops or 500 steps are over, and keeps what plots
/// need.
bench::EpisodeTrajectory RecordPrivileged(const std::shared_ptr<const sim::World>& world,
                                          const Trial& trial, const std::string& agent,
                                          sim::NoiseMode noise);

/// The same with a registered agent and the oracle, and the agent's belief at the end.
bench::EpisodeTrajectory RecordAgent(const std::shared_ptr<const sim::World>& world,
                                     const Trial& trial, const std::string& agent,
                                     sim::NoiseMode noise);

/// A trajectory that no run made, with every kind of mark and belief in it: from (1, 0, -1), facing
/// -z, two metres ahead and then to the right.
bench::EpisodeTrajectory MadeUpTrajectory();

}  // namespace bulletnav::tests
