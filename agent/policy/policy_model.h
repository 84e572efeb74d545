// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "agent/models/model.h"
#include "agent/observation.h"

namespace bulletnav::agent {

/// What a policy is asked with, in one step.
struct PolicyQuestion {
  Panorama panorama;
  std::span<const float> goal;             // from CodeOf
  std::span<const float> numbers;          // see WritePolicyNumbers
  std::span<const std::uint8_t> map = {};  // of PolicyMap, for a policy that sees it
};

/// A policy from panoramas to actions, with a memory that its user keeps. Deterministic. Source:
/// Neural Topological SLAM, section 5.1, the end-to-end baselines.
class PolicyModel : public virtual Model {
 public:
  static constexpr std::string_view kWhat = "policy";

  virtual int step_limit() const = 0;
  virtual bool sees_map() const { return false; }
  /// What it begins an episode with.
  virtual std::vector<float> NoMemory() const = 0;
  /// Of a goal; done once an episode.
  virtual std::vector<float> CodeOf(const Panorama& goal) = 0;
  /// Probabilities of the four actions, in the order of sim::Action. `memory` becomes that of after
  /// this step.
  virtual std::array<float, 4> Act(const PolicyQuestion& question, std::vector<float>* memory) = 0;
};

}  // namespace bulletnav::agent
