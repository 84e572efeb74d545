// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "agent/integer/integer_input.h"
#include "agent/integer/integer_trunk.h"
#include "agent/models/free_space_model.h"

namespace bulletnav::agent {

/// Where the middle of a map's cell lies on the ring of answers: between two bearings and two
/// ranges, shares of the second ones in 1/256.
struct RingPlace {
  std::int16_t bearing = 0;
  std::int16_t bearing_share = 0;
  std::int16_t range = 0;
  std::int16_t range_share = 0;
};
/// Of all cells, row by row; see MapperNet. `cols`: of the pictures.
std::vector<RingPlace> PlacesOnRing(int cols);

/// A FreeSpaceModel in integers: the same bits on every processor; see MapperNet, whose layers it
/// has by the same names. One per thread; all work is done in the calling thread.
class IntegerMapper final : public FreeSpaceModel {
 public:
  /// Throws Error if layers are missing or do not fit.
  IntegerMapper(const QuantisedNet& net, int rows);

  FreeSpace Predict(const Panorama& panorama) override;
  void Use(const IntegerKernels& kernels);

 private:
  static constexpr std::size_t kLevels = 3;
  struct Level {
    int stage;
    DotLayer layer;
    std::vector<std::int32_t> in_offsets;
    int columns;
    std::vector<std::int16_t> values;  // [columns, features]
  };
  void AddLevel(const QuantisedNet& net, int stage);
  void SumLevels();

  IntegerInput input_;
  IntegerTrunk trunk_;
  std::vector<Level> levels_;
  DotLayer hidden_;
  DotLayer rays_;
  int columns_;
  std::vector<RingPlace> places_;
  std::vector<std::int16_t> sums_;    // [columns, features]
  std::vector<std::int16_t> values_;  // likewise
  std::vector<std::int16_t> ring_;    // [bearings, 2, ranges] logits
};

}  // namespace bulletnav::agent
