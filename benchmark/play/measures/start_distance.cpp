// SPDX-License-Identifier: MIT
#include "benchmark/play/measure.h"

namespace bulletnav::bench {
namespace {

/// Geodesic metres from start to goal.
const MeasureRegistration registration({
    .name = "start_distance",
    .value =
        [](const GoalRecord& record, const SuccessRule& /*rule*/) {
          return record.start_distance;
        },
    .place = 50,
});

}  // namespace
}  // namespace bulletnav::bench
