// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <string_view>

namespace bulletnav::sim {

/// What an agent can do in one step: forward 0.25 m, turn 10 degrees, or end the episode.
/// Source: Neural Topological SLAM, section 5.
enum class Action { kStop, kMoveForward, kTurnLeft, kTurnRight };

inline constexpr std::array kAllActions = {Action::kStop, Action::kMoveForward, Action::kTurnLeft,
                                           Action::kTurnRight};

/// "stop", "move_forward", "turn_left", "turn_right".
std::string_view ActionName(Action action);

}  // namespace bulletnav::sim
