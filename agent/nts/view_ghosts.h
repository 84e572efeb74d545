// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <span>
#include <vector>

#include "agent/models/semantic_model.h"
#include "agent/nts/nts_spec.h"

namespace bulletnav::agent {

/// What the global policy minimises, in metres: the way to a ghost, weighed, and the way from there
/// to the goal as F_S has it.
double WayByGhost(const PolicySpec& spec, double way, double score);

/// A ghost that the present view would have if it were a node.
struct ViewGhost {
  double bearing = 0.0;   // radians from straight ahead
  double distance = 0.0;  // metres
  double score = 0.0;     // of its direction
  double way = 0.0;       // WayByGhost
};

/// A place seen from the body.
struct Opening {
  double bearing = 0.0;
  double distance = 0.0;
};

/// One for each explorable direction, 3 m away, and one for each opening; the best first.
std::vector<ViewGhost> GhostsOfView(const NtsSpec& spec,
                                    const std::array<float, kDirections>& explorable,
                                    const std::array<float, kDirections>& score,
                                    std::span<const Opening> openings);

}  // namespace bulletnav::agent
