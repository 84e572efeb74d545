// SPDX-License-Identifier: MIT
#pragma once
#include "benchmark/training/supervised/pair_batch.h"
#include "sim/math/rng.h"

namespace bulletnav::tests {

/// A place to stand in a plane: metres, radians counter-clockwise.
struct Stand {
  double x = 0.0;
  double y = 0.0;
  double heading = 0.0;
};

/// A plane with a coloured pillar in each quarter, all seen from everywhere: panoramas are bars on
/// grey, labels follow from geometry. A direction is explorable unless the red pillar is in it.
bench::PairBatch BarBatch(const std::vector<Stand>& stands);

/// Random stands; batches follow from seed and number.
class BarSource : public bench::BatchSource {
 public:
  BarSource(int count, std::uint64_t seed) : count_(count), seed_(seed) {}
  bench::PairBatch Batch(std::uint64_t number) const override;

 private:
  int count_;
  std::uint64_t seed_;
};

}  // namespace bulletnav::tests
