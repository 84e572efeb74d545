// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <memory>
#include <optional>

#include <sys/types.h>

namespace bulletnav::python {

/// Calls into Python that other threads may watch and interrupt.
class GuardedCall {
 public:
  GuardedCall();

  /// Takes Python's lock, does `work`, and throws std::runtime_error with the traceback of what it
  /// raised. A process that was forked off meanwhile ends here: nobody else may play the run on.
  void Run(const std::function<void()>& work);

  /// See PythonLane.
  std::optional<double> busy_s() const;
  void Interrupt();

 private:
  struct State;
  std::shared_ptr<State> state_;  // the interrupting thread has it too
};

/// Ends a process that is not `own`: an agent has forked it off.
void EndChild(pid_t own);

}  // namespace bulletnav::python
