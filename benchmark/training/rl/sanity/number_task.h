// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "benchmark/training/rl/lane_groups.h"
#include "benchmark/training/rl/policy_task.h"
#include "sim/math/rng.h"

namespace bulletnav::bench {

/// What small tasks on plain numbers have in common. All that a Lane is are whole numbers, which
/// it lists: `std::array<int*, N> Numbers();`
template <class Lane>
class NumberTask : public PolicyTask {
 public:
  /// `name`: of the task, whose chances are its own.
  NumberTask(std::string_view name, const LaneShare& share, std::uint64_t seed)
      : name_(name),
        seed_(seed),
        first_(share.first),
        lanes_(static_cast<std::size_t>(share.lanes)) {}

  int lanes() const final { return static_cast<int>(lanes_.size()); }
  int first_lane() const final { return first_; }

  std::vector<float> State() const final {
    std::vector<float> state;
    for (Lane lane : lanes_) {
      for (const int* number : lane.Numbers()) state.push_back(static_cast<float>(*number));
    }
    return state;
  }
  void SetState(std::span<const float> state) final {
    auto from = state.begin();
    for (Lane& lane : lanes_) {
      for (int* number : lane.Numbers()) *number = static_cast<int>(*from++);
    }
  }

 protected:
  sim::Rng RngOf(int lane, std::uint64_t episode) const {
    return sim::Rng(seed_, name_)
        .Fork("lane", static_cast<std::uint64_t>(first_ + lane))
        .Fork("episode", episode);
  }
  std::vector<Lane>& all_lanes() { return lanes_; }
  Lane& lane(int i) { return lanes_[static_cast<std::size_t>(i)]; }

 private:
  std::string name_;
  std::uint64_t seed_;
  int first_;
  std::vector<Lane> lanes_;
};

}  // namespace bulletnav::bench
