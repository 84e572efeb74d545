// SPDX-License-Identifier: MIT
#include "benchmark/play/measure.h"

namespace bulletnav::bench {
namespace {

/// Metres really moved.
const MeasureRegistration registration({
    .name = "path_length",
    .value =
        [](const GoalRecord& record, const SuccessRule& /*rule*/) {
          return record.path_length;
        },
    .place = 80,
});

}  // namespace
}  // namespace bulletnav::bench
