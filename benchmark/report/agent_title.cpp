// SPDX-License-Identifier: MIT
#include "benchmark/report/agent_title.h"

#include <algorithm>

#include "benchmark/runs/published.h"

namespace bulletnav::bench {

std::string AgentTitle(const std::string& agent, std::span<const AgentRow> agents) {
  const auto row = std::find_if(agents.begin(), agents.end(), [&](const AgentRow& one) {
    return one.agent == agent;
  });
  if (row != agents.end() && !row->title.empty()) return row->title;
  const std::string title(PublishedTitle(agent));
  return title.empty() ? agent : title;
}

std::string SettingTitle(std::string setting) {
  for (char& c : setting) {
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  }
  return setting;
}

}  // namespace bulletnav::bench
