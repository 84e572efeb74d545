// SPDX-License-Identifier: MIT
#pragma once
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <functional>
#include <thread>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

namespace bulletnav::tests {

using Delay = std::chrono::microseconds;

/// Does `work` in a process of its own, which is killed after `delay`, and again after what
/// `longer` makes of that, until it comes to its end. `after_kill` sees what each kill leaves.
/// Returns how many there were.
inline int KillUntilDone(const std::function<void()>& work, Delay delay,
                         const std::function<Delay(Delay)>& longer,
                         const std::function<void()>& after_kill = {}) {
  for (int kills = 0;; ++kills, delay = longer(delay)) {
    const pid_t child = ::fork();
    if (child < 0) {
      ADD_FAILURE() << "no process could be made";
      return kills;
    }
    if (child == 0) {
      work();
      std::_Exit(0);
    }
    std::this_thread::sleep_for(delay);
    ::kill(child, SIGKILL);
    int status = 0;
    ::waitpid(child, &status, 0);
    if (WIFEXITED(status)) return kills;
    if (after_kill) after_kill();
  }
}

}  // namespace bulletnav::tests
