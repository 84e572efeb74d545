// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string_view>

namespace bulletnav::bench {

/// What a paper reports for one row and column of its tables.
struct PublishedFigure {
  std::optional<double> success;
  std::optional<double> spl;
};

/// The figures on Gibson of Neural Topological SLAM: table 1 for the condition "noise", table 2
/// (success alone, "rgbd" alone) for "no_stop" and "no_noise". `difficulty`: "easy", "medium",
/// "hard" or "overall". Empty for what the paper does not have.
PublishedFigure FindPublished(std::string_view agent, std::string_view setting,
                              std::string_view condition, std::string_view difficulty);

/// What the paper calls an agent of ours; empty for those that are not in it.
std::string_view PublishedTitle(std::string_view agent);

}  // namespace bulletnav::bench
