// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>

#include "agent/belief.h"
#include "benchmark/base/json_cursor.h"

namespace bulletnav::bench {

/// To a millionth, so that files hold no more digits than mean something; never -0.
inline double Rounded(double value) {
  return std::round(value * 1e6) / 1e6 + 0.0;
}

Json ToJson(const sim::PlanarPose& pose);
sim::PlanarPose ReadPlanarPose(const JsonCursor& json);

/// The form is told in trajectory.h. Reading throws sim::FileError.
Json ToJson(const agent::Belief& belief);
agent::Belief ReadBelief(const JsonCursor& json);

}  // namespace bulletnav::bench
