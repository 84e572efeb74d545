// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <string>

#include "agent/agent.h"

namespace bulletnav::python {

/// What bulletnav-python.so, which alone knows libpython, does for the program: makes an agent of a
/// class in a Python module, "mine:MyAgent", with options as JSON. Throws sim::Error, in one line,
/// if there is no such module or class or it cannot be built.
/// The class:
///   __init__(self, rig, options)      rig: {"rows", "cols", "projection", "max_depth_m",
///                                     "has_color", "has_depth", "camera_height"}
///   reset(self, goal, seed)           goal: {"color": uint8 [rows, cols, 3], "depth": float32}
///   next_goal(self, goal, seed)       if there is one; else reset
///   act(self, observation)            an action, 0 to 3; observation: {array's name: array, ...,
///                                     "step": actions since reset}
/// Arrays are copies that it may keep. What it raises is thrown, with its traceback as the text.
using MakePythonAgent = void(const std::string& module, const std::string& options,
                             const agent::AgentContext& context,
                             std::unique_ptr<agent::Agent>* made);
inline constexpr const char* kMakePythonAgent = "BulletnavMakePythonAgent";
inline constexpr const char* kPythonLibrary = "bulletnav-python.so";

}  // namespace bulletnav::python
