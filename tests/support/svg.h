// SPDX-License-Identifier: MIT
#pragma once
#include <string>

namespace bulletnav::tests {

/// What is wrong with an SVG: tags that do not match, names that appear twice, references to
/// nothing; empty if it is sound. Knows the part of XML that cairo writes.
std::string SvgProblem(const std::string& svg);

}  // namespace bulletnav::tests
