// SPDX-License-Identifier: MIT
#pragma once
#include <string>

namespace bulletnav::bench {

/// "line 3 is 'seed: 1' there and 'seed: 2' here", of the first lines that differ in two texts.
std::string FirstDifference(const std::string& there, const std::string& here);

}  // namespace bulletnav::bench
