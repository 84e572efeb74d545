// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "benchmark/training/core/measures.h"
#include "benchmark/training/core/train_task.h"

namespace bulletnav::bench {

/// The card that goes with weights, in Markdown: what they are for, from which config, program,
/// seed and data they come, what the training took, and how they did on the validation houses.
/// `step`: steps done; `seconds`: that they took, of all parts of a training that was interrupted.
std::string ModelCard(const TrainTask& task, int step, double seconds, const Measures& validation);

}  // namespace bulletnav::bench
