// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "agent/agent.h"

namespace bulletnav::python {

/// An agent in Python for one body. What of it may be called from other threads is as
/// agent::ForeignAgent says.
class PythonLane : public agent::Agent {
 public:
  /// Seconds since the call at work has Python's lock; absent if there is none.
  virtual std::optional<double> busy_s() const = 0;
  /// Raises bulletnav_agent.TimeLimit, a BaseException, in the call at work, as soon as that comes
  /// to Python code. Code in C that does not come back is not reached.
  virtual void Interrupt() = 0;
  /// Its module and what that has imported from its own folder or package.
  virtual std::vector<std::filesystem::path> sources() const = 0;
};

/// What bulletnav-python.so, which alone knows libpython, does for the program: makes an agent of a
/// class in a Python module, "mine:MyAgent", with options as JSON. Throws sim::FileError, in one
/// line, if there is no such module or class or it cannot be built.
/// The class:
///   __init__(self, rig, options)      rig: {"rows", "cols", "projection", "max_depth_m",
///                                     "has_color", "has_depth", "camera_height"}
///   reset(self, goal, seed)           goal: {"color": uint8 [rows, cols, 3], "depth": float32}
///   next_goal(self, goal, seed)       if there is one; else reset
///   act(self, observation)            an action, 0 to 3; observation: {array's name: array, ...,
///                                     "step": actions since reset}
/// Arrays are copies that it may keep. What it raises is thrown, with its traceback as the text. A
/// child process that it forks ends when it comes back, and with the thread that forked it.
using MakePythonAgent = void(const std::string& module, const std::string& options,
                             const agent::AgentContext& context, std::unique_ptr<PythonLane>* made);
inline constexpr const char* kMakePythonAgent = "BulletnavMakePythonAgent";
inline constexpr const char* kPythonLibrary = "bulletnav-python.so";

}  // namespace bulletnav::python
