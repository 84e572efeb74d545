// SPDX-License-Identifier: MIT
#include "benchmark/training/supervised/true_free_space.h"

namespace bulletnav::bench {

agent::FreeSpace TrueFreeSpace::Predict(const agent::Panorama& panorama) {
  // On a corner of its cell, as in the middle of FreeSpace.
  ring_.Project(panorama, 0.0, 0.0, 0.0);
  agent::FreeSpace space;
  const int margin = ring_.reach() - agent::FreeSpace::kSide / 2;
  for (std::size_t i = 0; i < space.explored.values().size(); ++i) {
    const sim::Cell cell = space.explored.cell(i);
    const sim::Cell seen{cell.x + margin, cell.y + margin};
    space.explored[i] = ring_.seen()[seen] != 0 ? 1.0f : 0.0f;
    space.obstacle[i] = ring_.obstacle_points()[seen] >= spec_.obstacle_points ? 1.0f : 0.0f;
  }
  return space;
}

}  // namespace bulletnav::bench
