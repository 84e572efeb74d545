// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "benchmark/training/core/trainer.h"

namespace bulletnav::bench {

/// The card that goes with weights, in Markdown: what they are for, from which config, program,
/// seed and data they come, what the training took, and how they did when last validated.
/// `step`: steps done; `seconds`: that they took, of all parts of a training that was interrupted.
std::string ModelCard(const TrainJob& job, int step, double seconds, const Measures& validation);

}  // namespace bulletnav::bench
