// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>

#include "benchmark/training/core/trainer.h"

namespace bulletnav::bench {

/// The last validation, of the trained network and of the one in integers that it became.
struct CardMeasures {
  Measures floats;
  std::optional<Measures> integers;
};

/// The card that goes with weights, in Markdown: what they are for, from which config, program,
/// seed and data they come, what the training took, and how they did when last validated.
/// `step`: steps done; `seconds`: that they took, of all parts of a training that was interrupted.
std::string ModelCard(const TrainJob& job, int step, double seconds, const CardMeasures& measures);

}  // namespace bulletnav::bench
