// SPDX-License-Identifier: MIT
#pragma once
#include "python/core/lanes_config.h"
#include "python/core/world_shelf.h"

#include <cstdint>
#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <sys/types.h>

#include "benchmark/play/vector_environment.h"

namespace bulletnav::python {

/// Throws sim::Error, naming the actions there are, for what is none.
std::vector<sim::Action> ReadActions(const std::vector<std::int64_t>& numbers);

/// A bench::VectorEnvironment that no misuse from Python can hurt: calls after Close, in a process
/// that was forked off, from two threads at once, or between Send and Receive throw sim::Error.
/// Knows nothing of Python; its calls are made without the interpreter's lock.
class Lanes {
 public:
  /// `config`: a LanesConfig as YAML or JSON. Throws sim::Error for what is wrong in it, and for
  /// scenes and episodes that cannot be had.
  /// `warn` is called once for each scene that is drawn grey; see bench::SceneCache.
  explicit Lanes(const std::string& config, bench::Warn warn = {});
  ~Lanes();
  Lanes(const Lanes&) = delete;
  Lanes& operator=(const Lanes&) = delete;
  Lanes(Lanes&&) = delete;
  Lanes& operator=(Lanes&&) = delete;

  const LanesConfig& config() const { return config_; }

  /// With a seed, or for the first time: begins anew in all lanes. Else the next episodes.
  void Reset(std::optional<std::uint64_t> seed);
  /// The next episodes of some lanes.
  void ResetLanes(std::vector<int> lanes);
  /// One action, 0 to 3, for each of some rising lanes; absent: of all. Throws sim::Error for what
  /// is no action.
  void Step(const std::vector<std::int64_t>& actions, const std::optional<std::vector<int>>& lanes);
  /// As Step, but returns at once; Receive waits for it and throws what it threw. Returns the
  /// lanes.
  void Send(const std::vector<std::int64_t>& actions, const std::optional<std::vector<int>>& lanes);
  std::vector<int> Receive();
  void Close();
  bool is_closed() const { return is_closed_; }

  /// Calls look(environment). Throws as all others.
  template <class Look>
  auto View(const Look& look) {
    const auto use = Use();
    return look(*environment_);
  }
  /// For views of its memory; they keep it.
  std::shared_ptr<const bench::VectorEnvironment> environment() const { return environment_; }

 private:
  struct Order {
    std::vector<int> lanes;
    std::vector<sim::Action> actions;
  };
  /// The right to call the environment, as long as it lives.
  std::unique_lock<std::mutex> Use(bool is_receiving = false);
  Order Read(const std::vector<std::int64_t>& actions,
             const std::optional<std::vector<int>>& lanes) const;
  std::vector<bench::Episode> Episodes();

  LanesConfig config_;
  pid_t process_;
  std::unique_ptr<WorldShelf> worlds_;
  std::shared_ptr<bench::VectorEnvironment> environment_;
  std::mutex mutex_;
  bool is_begun_ = false;
  bool is_closed_ = false;
  std::vector<int> sent_;
  std::future<void> under_way_;
};

}  // namespace bulletnav::python
