// SPDX-License-Identifier: MIT
#include "benchmark/play/measure.h"

namespace bulletnav::bench {
namespace {

/// Geodesic metres at the end; infinite off the goal's island, where means take the straight line.
const MeasureRegistration registration({
    .name = "distance_to_goal",
    .value =
        [](const GoalRecord& record, const SuccessRule& /*rule*/) {
          return record.distance_to_goal;
        },
    .kind = MeasureKind::kRealOrInfinite,
    .place = 60,
    .if_infinite = "euclidean_distance",
    .column = "distance_to_goal_mean",
});

}  // namespace
}  // namespace bulletnav::bench
