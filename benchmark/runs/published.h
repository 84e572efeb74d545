// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <optional>
#include <string_view>

namespace bulletnav::bench {

/// The measures that the paper has figures of.
inline constexpr std::array<std::string_view, 2> kPublishedMeasures = {"success", "spl"};

/// A figure on Gibson of Neural Topological SLAM: table 1 for the condition "noise", table 2
/// (success alone, "rgbd" alone) for "no_stop" and "no_noise". `difficulty`: "easy", "medium",
/// "hard" or "overall". Empty for what the paper does not have.
std::optional<double> FindPublished(std::string_view measure, std::string_view agent,
                                    std::string_view setting, std::string_view condition,
                                    std::string_view difficulty);

/// What the paper calls an agent of ours; empty for those that are not in it.
std::string_view PublishedTitle(std::string_view agent);

}  // namespace bulletnav::bench
