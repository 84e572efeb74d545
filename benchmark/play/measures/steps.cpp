// SPDX-License-Identifier: MIT
#include "benchmark/play/measure.h"

namespace bulletnav::bench {
namespace {

/// Actions but for the stop that ends the goal.
const MeasureRegistration registration({
    .name = "steps",
    .value = [](const GoalRecord& record, const SuccessRule& /*rule*/) -> double {
      return record.steps;
    },
    .kind = MeasureKind::kWhole,
    .place = 90,
    .over_goals = OverGoals::kSum,
    .column = "steps_mean",
    .column_place = ColumnPlace::kBeforePaper,
});

}  // namespace
}  // namespace bulletnav::bench
