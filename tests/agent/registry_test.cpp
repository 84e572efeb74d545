// SPDX-License-Identifier: MIT
#include "agent/registry.h"

#include <algorithm>
#include <filesystem>

#include <gtest/gtest.h>

#include "sim/base/error.h"

namespace bulletnav::agent {
namespace {

using sim::ParseYaml;

/// The message of what `call` throws.
template <class Call>
std::string ErrorOf(const Call& call) {
  try {
    call();
  } catch (const sim::Error& e) {
    return e.what();
  }
  return "no error";
}

TEST(Registry, HasOneAgentForEachFileOfTheFolderOfTheSameName) {
  std::vector<std::string> files;
  for (const auto& entry :
       std::filesystem::directory_iterator(BULLETNAV_SOURCE_DIR "/agent/baselines")) {
    if (entry.path().extension() == ".cpp") files.push_back(entry.path().stem().string());
  }
  std::sort(files.begin(), files.end());
  EXPECT_EQ(AgentNames(), files);
}

TEST(Registry, AnswersAnUnknownNameWithTheKnownOnes) {
  const std::string error = ErrorOf([] {
    ConfigureAgent("randon");
  });
  EXPECT_NE(error.find("'randon'"), std::string::npos) << error;
  for (const std::string& name : AgentNames()) {
    EXPECT_NE(error.find(name), std::string::npos) << error;
  }
}

TEST(Registry, SaysWhereAnUnknownNameStands) {
  const auto name = ParseYaml("\n  randon", "c.yaml");
  EXPECT_EQ(ErrorOf([&] {
              ConfigureAgent(name, {});
            }).find("c.yaml:2:3"),
            0u);
}

TEST(Registry, SaysWhereAnAgentsConfigIsWrong) {
  const auto error = [](const std::string& yaml) {
    return ErrorOf([&] {
      ConfigureAgent("random", ParseYaml(yaml, "c.yaml"));
    });
  };
  EXPECT_EQ(error("forward: 0.5\nstopp: 1").find("c.yaml:2:1"), 0u);
  EXPECT_NE(error("forward: 0.5\nstopp: 1").find("'stop'"), std::string::npos);
  EXPECT_EQ(error("forward: much").find("c.yaml:1:10"), 0u);
  EXPECT_NE(error("forward: 2").find("probabilities"), std::string::npos);
  EXPECT_EQ(error("forward: 0.2"), "no error");
  EXPECT_EQ(error("~"), "no error");
}

/// Answers every lane with its number of turns so far, to see who is called.
class Counting final : public BatchAgent {
 public:
  static constexpr std::string_view kName = "counting";
  struct Config {
    template <class V>
    void Visit(V& /*v*/) {}
  };

  Counting(const Config& /*config*/, std::span<const AgentContext> contexts)
      : steps_(contexts.size()) {}

  int lanes() const override { return static_cast<int>(steps_.size()); }
  void Reset(int lane, const Panorama& /*goal*/, std::uint64_t /*seed*/) override {
    steps_[static_cast<std::size_t>(lane)] = 0;
  }
  void NextGoal(int /*lane*/, const Panorama& /*goal*/, std::uint64_t /*seed*/) override {}
  void Act(std::span<const LaneObservation> observations, std::span<sim::Action> actions) override {
    for (std::size_t i = 0; i < observations.size(); ++i) {
      const int step = ++steps_[static_cast<std::size_t>(observations[i].lane)];
      actions[i] = step > 1 ? sim::Action::kStop : sim::Action::kTurnLeft;
    }
  }

 private:
  std::vector<int> steps_;
};

TEST(Registry, TakesAgentsThatBatchThroughTheSameRegistration) {
  const std::array<AgentContext, 3> contexts;
  const auto agent = internal::MakeLanes<Counting>({}, contexts);
  ASSERT_EQ(agent->lanes(), 3);
  std::array<sim::Action, 2> actions{};
  agent->Act(std::array{LaneObservation{2, {}}, LaneObservation{0, {}}}, actions);
  agent->Act(std::array{LaneObservation{1, {}}, LaneObservation{2, {}}}, actions);
  EXPECT_EQ(actions[0], sim::Action::kTurnLeft);
  EXPECT_EQ(actions[1], sim::Action::kStop);
}

}  // namespace
}  // namespace bulletnav::agent
