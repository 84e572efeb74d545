// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "benchmark/report/figure.h"

namespace bulletnav::bench {

/// Accepted loops of one detector over all drives, by how far the later camera is turned from the
/// earlier one: twelve bins of 15 degrees.
struct HeadingCounts {
  static constexpr int kBins = 12;
  std::string name;
  std::vector<int> right = std::vector<int>(kBins, 0);
  std::vector<int> wrong = std::vector<int>(kBins, 0);

  void Add(double turned_deg, bool is_wrong);
};

/// The paper's figure 6: a panel a detector, all to the same height; right loops in blue, wrong
/// ones in vermillion on top of them.
Figure HeadingHistogram(const std::vector<HeadingCounts>& detectors);

}  // namespace bulletnav::bench
