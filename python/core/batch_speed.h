// SPDX-License-Identifier: MIT
#pragma once
#include "python/core/lanes.h"

#include <cstdint>
#include <vector>

namespace bulletnav::python {

/// What stepping costs without an environment and without Python, to compare with: a
/// sim::BatchSimulator of as many lanes and threads, in the same worlds, from where the bodies now
/// are, with the same sensors and noise. Returns the seconds that `actions`, [steps][lanes], take;
/// `warm_up` steps before them are not counted. Throws sim::Error for what is no action.
double BatchSeconds(Lanes* lanes, const std::vector<std::vector<std::int64_t>>& actions,
                    std::size_t warm_up);

}  // namespace bulletnav::python
