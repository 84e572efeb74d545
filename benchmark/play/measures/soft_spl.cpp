// SPDX-License-Identifier: MIT
#include <algorithm>

#include "benchmark/play/measure.h"

namespace bulletnav::bench {
namespace {

/// max(0, 1 - d / d0): how much of the distance is gone.
double Progress(const GoalRecord& record) {
  if (record.start_distance > 0.0) {
    return std::max(0.0, 1.0 - record.distance_to_goal / record.start_distance);
  }
  return record.distance_to_goal > 0.0 ? 0.0 : 1.0;
}

/// max(0, 1 - d / d0) * d0 / max(d0, L).
/// Source: Datta et al., "Integrating egocentric localization for more realistic point-goal
/// navigation agents", 2020.
double SoftSpl(const GoalRecord& record, const SuccessRule& /*rule*/) {
  return Progress(record) * Directness(record);
}

const MeasureRegistration registration({
    .name = "soft_spl",
    .value = SoftSpl,
    .place = 40,
    .column = "soft_spl",
    .column_place = ColumnPlace::kBeforePaper,
});

}  // namespace
}  // namespace bulletnav::bench
