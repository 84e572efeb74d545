// SPDX-License-Identifier: MIT
#include "benchmark/play/measure.h"

namespace bulletnav::bench {
namespace {

/// Metres at the end, as the crow flies.
const MeasureRegistration registration({
    .name = "euclidean_distance",
    .value =
        [](const GoalRecord& record, const SuccessRule& /*rule*/) {
          return record.euclidean_distance;
        },
    .place = 70,
});

}  // namespace
}  // namespace bulletnav::bench
