// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string_view>

#include "agent/models/model.h"
#include "agent/observation.h"

namespace bulletnav::agent {

/// A place seen from the body: metres, and radians counter-clockwise from straight ahead; the
/// probability that it is the goal's.
struct RelativeGoal {
  double distance = 0.0;
  double bearing = 0.0;
  double certainty = 1.0;
};

/// Says whether the goal can be seen from here, and where it then is: the localisation F_L and the
/// relative pose F_R of Neural Topological SLAM, section 4. One per body; it may keep a state.
class GoalEstimator : public virtual Model {
 public:
  static constexpr std::string_view kWhat = "goal estimator";

  /// Absent if the two panoramas do not show the same place.
  virtual std::optional<RelativeGoal> Estimate(const Panorama& here, const Panorama& goal) = 0;
};

}  // namespace bulletnav::agent
