// SPDX-License-Identifier: MIT
#include "benchmark/report/agent_title.h"

#include <vector>

#include <gtest/gtest.h>

namespace bulletnav::bench {
namespace {

TEST(AgentTitle, IsTheConfigsThenThePapersThenTheName) {
  std::vector<AgentRow> agents = {{"nts", "Mine", {}, ""}, {"random", "", {}, ""}};
  EXPECT_EQ(AgentTitle("nts", agents), "Mine");
  EXPECT_EQ(AgentTitle("random", agents), "random");
  EXPECT_EQ(AgentTitle("nts", {}), "Neural Topological SLAM (NTS)");
  EXPECT_EQ(AgentTitle("spinner", agents), "spinner");
}

}  // namespace
}  // namespace bulletnav::bench
