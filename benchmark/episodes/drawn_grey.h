// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>

#include "benchmark/base/warn_line.h"
#include "sim/scene/import.h"

namespace bulletnav::bench {

/// One line that says what of a scene is drawn grey since its picture or material is missing or
/// cannot be read; empty if nothing is.
std::string DrawnGrey(const std::filesystem::path& scene, const sim::ImportReport& import);

}  // namespace bulletnav::bench
