// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <string>

#include "benchmark/runs/summary.h"

namespace bulletnav::bench {

/// What tables call an agent: its title in the config, else the paper's, else its name.
std::string AgentTitle(const std::string& agent, std::span<const AgentRow> agents);

/// "RGBD" for "rgbd".
std::string SettingTitle(std::string setting);

}  // namespace bulletnav::bench
