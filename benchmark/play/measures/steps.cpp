// SPDX-License-Identifier: MIT
#include "benchmark/play/measure.h"

namespace bulletnav::bench {
namespace {

/// Actions but for the stop that ends the goal.
double Steps(const GoalRecord& record, const SuccessRule& /*rule*/) {
  return record.steps;
}

const MeasureRegistration registration({
    .name = "steps",
    .value = Steps,
    .kind = MeasureKind::kWhole,
    .place = 90,
    .over_goals = OverGoals::kSum,
    .column = "steps_mean",
    .column_place = ColumnPlace::kBeforePaper,
});

}  // namespace
}  // namespace bulletnav::bench
