// SPDX-License-Identifier: MIT
#include "benchmark/play/measure.h"

namespace bulletnav::bench {
namespace {

/// Steps in which the body met something.
double Collisions(const GoalRecord& record, const SuccessRule& /*rule*/) {
  return record.collisions;
}

const MeasureRegistration registration({
    .name = "collisions",
    .value = Collisions,
    .kind = MeasureKind::kWhole,
    .place = 100,
    .over_goals = OverGoals::kSum,
    .column = "collisions_mean",
    .column_place = ColumnPlace::kBeforePaper,
});

}  // namespace
}  // namespace bulletnav::bench
