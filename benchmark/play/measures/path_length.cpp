// SPDX-License-Identifier: MIT
#include "benchmark/play/measure.h"

namespace bulletnav::bench {
namespace {

/// Metres really moved.
double PathLength(const GoalRecord& record, const SuccessRule& /*rule*/) {
  return record.path_length;
}

const MeasureRegistration registration({
    .name = "path_length",
    .value = PathLength,
    .place = 80,
});

}  // namespace
}  // namespace bulletnav::bench
