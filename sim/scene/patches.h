// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "sim/scene/mesh.h"

namespace bulletnav::sim {

/// The threshold above which `values` have the given share of all `weights`, as near as can be.
/// Infinity for a share of 0 or no values. Expects: spans of one size (checked).
float ThresholdOf(std::span<const float> values, std::span<const double> weights, double share);

}  // namespace bulletnav::sim
