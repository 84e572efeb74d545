// SPDX-License-Identifier: MIT
#include "benchmark/play/measure.h"

namespace bulletnav::bench {
namespace {

/// Whether the agent stopped near the goal by the geodesic distance.
/// Source: Anderson et al., "On evaluation of embodied navigation agents", 2018; a metre: Neural
/// Topological SLAM.
const MeasureRegistration registration({
    .name = "success",
    .value =
        [](const GoalRecord& record, const SuccessRule& rule) {
          return IsNear(record.distance_to_goal, record, rule) ? 1.0 : 0.0;
        },
    .kind = MeasureKind::kYesNo,
    .place = 10,
    .column = "success",
    .column_place = ColumnPlace::kBeforePaper,
    .label = "success",
    .table_title = "Succ",
});

}  // namespace
}  // namespace bulletnav::bench
