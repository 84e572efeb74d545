// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "agent/agent.h"
#include "benchmark/play/ground_truth.h"
#include "benchmark/runs/run_config.h"

namespace bulletnav::bench {

/// What fills one slot of an agent in one setting.
struct SlotSource {
  agent::ModelSlot slot;
  bool is_oracle = false;
  std::string key;   // of the weights among a run's fingerprints; empty: no file
  std::string name;  // the file as the config says it
  std::optional<std::filesystem::path> file = std::nullopt;  // where it is, if it is there
};

/// What fills the slots of an entry on a body with this rig; slots that are left empty are not
/// there.
std::vector<SlotSource> SourcesOf(const AgentEntry& entry, const RunConfig& config,
                                  const std::string& setting);

/// The files of weights that a config's agents use, by key; without those that are missing.
std::map<std::string, std::filesystem::path> UsedWeights(const RunConfig& config);

/// Throws Error for a key of `weights` that no agent of this version asks for: it would be left out
/// in silence.
void RequireKnownWeights(const RunConfig& config);

/// Whether some network acts in floats, whose last bits depend on the kind of processor; those in
/// integers are the same everywhere. Throws FileError if weights cannot be read.
bool ActsInFloats(const RunConfig& config);

/// As FindShipped. Throws FileError if there is none.
std::filesystem::path FindWeights(const std::string& weights);

/// The contexts of all lanes, one for each of `truths`, which oracles look at. Lanes share models
/// from files. Throws FileError if weights are missing or cannot be used, Error if there is no
/// oracle for a slot.
std::vector<agent::AgentContext> ContextsOf(const AgentEntry& entry,
                                            std::span<const SlotSource> sources,
                                            const agent::Rig& rig,
                                            std::span<const GroundTruth* const> truths);

}  // namespace bulletnav::bench
