// SPDX-License-Identifier: MIT
#include "benchmark/play/measure.h"

namespace bulletnav::bench {
namespace {

/// Success by the straight line: stops behind a wall count too.
const MeasureRegistration registration({
    .name = "success_euclidean",
    .value =
        [](const GoalRecord& record, const SuccessRule& rule) {
          return IsNear(record.euclidean_distance, record, rule) ? 1.0 : 0.0;
        },
    .kind = MeasureKind::kYesNo,
    .place = 20,
    .column = "success_euclidean",
    .column_place = ColumnPlace::kBeforePaper,
    .table_title = "Succ",
    .table_head = "Euclidean",
});

}  // namespace
}  // namespace bulletnav::bench
