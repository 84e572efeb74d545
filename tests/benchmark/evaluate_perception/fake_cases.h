// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "benchmark/evaluate_perception/perception_cases.h"

namespace bulletnav::tests {

/// A scene of places drawn at random in a square of 12 m, whose labels are as random as can be but
/// agree with the places: pairs nearer than 3 m are mostly of one node, every third direction or so
/// is explorable. Nothing is predicted yet.
bench::SceneCases RandomCases(std::uint64_t seed, int places);

/// What a model that never errs says.
void PredictTruth(bench::SceneCases* cases);
/// The same of everything.
void PredictConstant(bench::SceneCases* cases);

}  // namespace bulletnav::tests
