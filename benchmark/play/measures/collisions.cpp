// SPDX-License-Identifier: MIT
#include "benchmark/play/measure.h"

namespace bulletnav::bench {
namespace {

/// Steps in which the body met something.
const MeasureRegistration registration({
    .name = "collisions",
    .value = [](const GoalRecord& record, const SuccessRule& /*rule*/) -> double {
      return record.collisions;
    },
    .kind = MeasureKind::kWhole,
    .place = 100,
    .over_goals = OverGoals::kSum,
    .column = "collisions_mean",
    .column_place = ColumnPlace::kBeforePaper,
});

}  // namespace
}  // namespace bulletnav::bench
