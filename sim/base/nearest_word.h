// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace bulletnav::sim {

/// The member of `known` that the fewest letters put in, left out or changed make of `word`, the
/// first of several; empty if all take more than `letters`.
std::string NearestWord(std::string_view word, const std::vector<std::string>& known,
                        std::size_t letters);

}  // namespace bulletnav::sim
