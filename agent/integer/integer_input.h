// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "agent/integer/pictures.h"
#include "agent/observation.h"

namespace bulletnav::agent {

inline constexpr int kInputRows = 128;

/// Panoramas of 128 x 512, or of `panorama_rows`, to the input of a trunk: means over squares, so
/// that as many rows are left as `rows` says; 0 to 254 for colours, and for depths of 0 to 10 m. Of
/// colours 127 is half, of depths 5 m. Rounds to the nearest; depths are first cut to 1/256 m.
class IntegerInput {
 public:
  /// `rows` must be all, a half or a quarter of the panorama's.
  IntegerInput(int rows, bool uses_depth, int panorama_rows = kInputRows);

  /// Expects: a panorama of the right size (checked).
  void Prepare(const Panorama& panorama, int index, Pictures* pictures) const;

 private:
  int rows_;  // of the panorama
  int factor_;
  bool uses_depth_;
  std::vector<std::uint8_t> color_of_sum_;
  std::vector<std::uint8_t> depth_of_sum_;
};

}  // namespace bulletnav::agent
