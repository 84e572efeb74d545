// SPDX-License-Identifier: MIT
#include "agent/nts/view_ghosts.h"

#include <algorithm>

namespace bulletnav::agent {

double WayByGhost(const PolicySpec& spec, double way, double score, double distance) {
  const double penalty = distance < kNodeRadius ? spec.near_penalty : 0.0;
  return spec.path_weight * way + kFarthestScored * (1.0 - score) + penalty;
}

std::vector<ViewGhost> GhostsOfView(const NtsSpec& spec,
                                    const std::array<float, kDirections>& explorable,
                                    const std::array<float, kDirections>& score) {
  std::vector<ViewGhost> ghosts;
  for (int i = 0; i < kDirections; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const bool is_far = explorable[k] >= spec.graph.explorable;
    const double distance = is_far ? kNodeRadius : spec.policy.near_ghost;
    ghosts.push_back({i, distance, WayByGhost(spec.policy, distance, score[k], distance)});
  }
  std::stable_sort(ghosts.begin(), ghosts.end(), [](const ViewGhost& a, const ViewGhost& b) {
    return a.way < b.way;
  });
  return ghosts;
}

}  // namespace bulletnav::agent
