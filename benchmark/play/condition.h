// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <string_view>
#include <utility>

#include "sim/config/enum_names.h"

namespace bulletnav::bench {

/// What an episode is played under, in the order of tables. kNoStop: being near the goal ends the
/// episode, a stop does nothing. kNoNoise: exact motion and odometry.
/// Source: Neural Topological SLAM, table 2.
enum class Condition { kNoise, kNoStop, kNoNoise };

}  // namespace bulletnav::bench

template <>
struct bulletnav::sim::EnumNames<bulletnav::bench::Condition> {
  static constexpr std::array kNames = {
      std::pair{"noise", bulletnav::bench::Condition::kNoise},
      std::pair{"no_stop", bulletnav::bench::Condition::kNoStop},
      std::pair{"no_noise", bulletnav::bench::Condition::kNoNoise}};
};
