// SPDX-License-Identifier: MIT
#pragma once
#include <memory>

#include "agent/policy/policy_input.h"
#include "agent/policy/policy_model.h"

namespace bulletnav::agent {

class PolicyNet;

/// A PolicyModel with weights learned in the simulator, for one thread; works in the calling one.
class LearnedPolicy final : public PolicyModel {
 public:
  /// `net` infers: it may be shared with others that do.
  explicit LearnedPolicy(std::shared_ptr<PolicyNet> net);
  ~LearnedPolicy() override;

  int step_limit() const override;
  bool sees_map() const override;
  std::vector<float> NoMemory() const override;
  std::vector<float> CodeOf(const Panorama& goal) override;
  std::array<float, 4> Act(const PolicyQuestion& question, std::vector<float>* memory) override;

 private:
  std::shared_ptr<PolicyNet> net_;
  PolicyPictures pictures_;
};

}  // namespace bulletnav::agent
