// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "benchmark/episodes/episode.h"

namespace bulletnav::bench {

/// What a set of episodes holds, as text to print: how many of which difficulty from how many
/// scenes, and histograms of the geodesic distance and of its ratio to the straight line, over all
/// goals of all episodes.
std::string DescribeEpisodes(const std::vector<Episode>& episodes);

/// Bars of text, one line a bin: [low, low + width), ... over the values, of which the first and
/// last bin take what is beyond. Empty bins at both ends are left out.
std::string TextHistogram(const std::vector<double>& values, double low, double width, int bins);

}  // namespace bulletnav::bench
