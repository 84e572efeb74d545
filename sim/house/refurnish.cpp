// SPDX-License-Identifier: MIT
#include "sim/house/refurnish.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "sim/config/yaml_reader.h"

namespace bulletnav::sim {

void Refurnish::Validate() const {
  if (!(share >= 0.0 && share <= 1.0)) throw KeyError("share", "share must lie between 0 and 1");
}

std::vector<Rng> RoomRngs(const Rng& rng, int rooms, const Refurnish& refurnish) {
  std::vector<Rng> rngs(static_cast<std::size_t>(rooms), rng);
  if (refurnish.share == 0.0) return rngs;
  const Rng anew = rng.Fork("anew", refurnish.seed);
  std::vector<std::size_t> order(rngs.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  Rng choice = anew.Fork("choice");
  choice.Shuffle(order);
  const auto count = std::max<std::size_t>(
      1, static_cast<std::size_t>(std::lround(refurnish.share * static_cast<double>(rooms))));
  for (std::size_t i = 0; i < std::min(count, order.size()); ++i) {
    rngs[order[i]] = anew;
  }
  return rngs;
}

}  // namespace bulletnav::sim
