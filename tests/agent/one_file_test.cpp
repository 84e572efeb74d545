// SPDX-License-Identifier: MIT
// An agent added the way docs/extending.md says: one file, nothing else touched. Up to the line of
// slashes this is what would stand in agent/baselines/spinner.cpp.
#include "agent/registry.h"
#include "sim/base/error.h"

namespace bulletnav::agent {
namespace {

/// Turns round and round, then stops.
class SpinnerAgent final : public Agent {
 public:
  static constexpr std::string_view kName = "spinner";

  struct Config {
    int turns = 36;
    template <class V>
    void Visit(V& v) {
      v("turns", turns);
    }
    void Validate() const {
      if (turns < 0) throw sim::Error("turns must not be negative");
    }
  };

  SpinnerAgent(const Config& config, const AgentContext& /*context*/) : config_(config) {}

  void Reset(const Panorama& /*goal*/, std::uint64_t /*seed*/) override { turned_ = 0; }

  sim::Action Act(const Observation& /*observation*/) override {
    return turned_++ < config_.turns ? sim::Action::kTurnLeft : sim::Action::kStop;
  }

 private:
  Config config_;
  int turned_ = 0;
};

const AgentRegistration<SpinnerAgent> registration;

}  // namespace
}  // namespace bulletnav::agent

////////////////////////////////////////////////////////////////////////////////////////////////////

#include <algorithm>
#include <array>

#include <gtest/gtest.h>

namespace bulletnav::agent {
namespace {

int StepsUntilStop(BatchAgent* agent) {
  agent->Reset(0, {}, 1);
  std::array actions = {sim::Action::kTurnLeft};
  int steps = 0;
  while (actions[0] != sim::Action::kStop && steps < 100) {
    const std::array observations = {LaneObservation{0, {{}, {}, false, steps++}}};
    agent->Act(observations, actions);
  }
  return steps;
}

TEST(OneFile, IsEnoughForAnAgent) {
  const auto names = AgentNames();
  EXPECT_NE(std::find(names.begin(), names.end(), "spinner"), names.end());
  const std::array contexts = {AgentContext{}};
  EXPECT_EQ(StepsUntilStop(ConfigureAgent("spinner")(contexts).get()), 37);
  const auto config = sim::ParseYaml("turns: 3", "c.yaml");
  EXPECT_EQ(StepsUntilStop(ConfigureAgent("spinner", config)(contexts).get()), 4);
}

TEST(OneFile, ASecondAgentOfTheSameNameIsRefused) {
  try {
    const AgentRegistration<SpinnerAgent> again;
    FAIL();
  } catch (const sim::Error& e) {
    EXPECT_NE(std::string(e.what()).find("'spinner'"), std::string::npos);
  }
}

}  // namespace
}  // namespace bulletnav::agent
