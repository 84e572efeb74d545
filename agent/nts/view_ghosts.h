// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <vector>

#include "agent/nts/nts_spec.h"
#include "agent/perception/semantic_model.h"

namespace bulletnav::agent {

/// What the global policy minimises, in metres: the way to a ghost, weighed, and the way from there
/// to the goal as F_S has it. `distance`: of the ghost from its node.
double WayByGhost(const PolicySpec& spec, double way, double score, double distance);

/// A ghost that the present view would have if it were a node.
struct ViewGhost {
  int direction = 0;
  double distance = 0.0;  // kNodeRadius, or PolicySpec::near_ghost where that is not explorable
  double way = 0.0;       // WayByGhost
};

/// One for each direction, the best first. F_G misses openings that no direction meets at 3 m; F_S
/// may still speak for going some of the way.
std::vector<ViewGhost> GhostsOfView(const NtsSpec& spec,
                                    const std::array<float, kDirections>& explorable,
                                    const std::array<float, kDirections>& score);

}  // namespace bulletnav::agent
