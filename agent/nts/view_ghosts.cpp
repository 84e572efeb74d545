// SPDX-License-Identifier: MIT
#include "agent/nts/view_ghosts.h"

#include <algorithm>

#include "agent/perception/relative_pose.h"

namespace bulletnav::agent {

double WayByGhost(const PolicySpec& spec, double way, double score) {
  return spec.path_weight * way + kFarthestScored * (1.0 - score);
}

std::vector<ViewGhost> GhostsOfView(const NtsSpec& spec,
                                    const std::array<float, kDirections>& explorable,
                                    const std::array<float, kDirections>& score,
                                    std::span<const Opening> openings) {
  std::vector<ViewGhost> ghosts;
  const auto add = [&](double bearing, double distance) {
    const double says = score[static_cast<std::size_t>(DirectionOf(bearing))];
    ghosts.push_back({bearing, distance, says, WayByGhost(spec.policy, distance, says)});
  };
  for (int i = 0; i < kDirections; ++i) {
    if (explorable[static_cast<std::size_t>(i)] < spec.graph.explorable) continue;
    add(BearingOf(i), kNodeRadius);
  }
  for (const Opening& opening : openings) add(opening.bearing, opening.distance);
  std::stable_sort(ghosts.begin(), ghosts.end(), [](const ViewGhost& a, const ViewGhost& b) {
    return a.way < b.way;
  });
  return ghosts;
}

}  // namespace bulletnav::agent
