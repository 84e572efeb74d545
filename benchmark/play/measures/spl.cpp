// SPDX-License-Identifier: MIT
#include "benchmark/play/measure.h"

namespace bulletnav::bench {
namespace {

/// success * d0 / max(d0, L); 1 for a success with d0 = L = 0.
/// Source: Anderson et al., "On evaluation of embodied navigation agents", 2018.
const MeasureRegistration registration({
    .name = "spl",
    .value =
        [](const GoalRecord& record, const SuccessRule& rule) {
          return IsNear(record.distance_to_goal, record, rule) ? Directness(record) : 0.0;
        },
    .place = 30,
    .column = "spl",
    .column_place = ColumnPlace::kBeforePaper,
    .label = "SPL",
    .table_title = "SPL",
});

}  // namespace
}  // namespace bulletnav::bench
