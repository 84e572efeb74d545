// SPDX-License-Identifier: MIT
#include "benchmark/play/measure.h"

namespace bulletnav::bench {
namespace {

/// Geodesic metres from start to goal.
double StartDistance(const GoalRecord& record, const SuccessRule& /*rule*/) {
  return record.start_distance;
}

const MeasureRegistration registration({
    .name = "start_distance",
    .value = StartDistance,
    .place = 50,
});

}  // namespace
}  // namespace bulletnav::bench
