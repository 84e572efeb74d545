// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <functional>
#include <string>

#include "sim/scene/import.h"

namespace bulletnav::bench {

/// Takes a line that warns the user.
using Warn = std::function<void(const std::string& line)>;

/// One line that says what of a scene is drawn grey since its picture or material is missing or
/// cannot be read; empty if nothing is.
std::string DrawnGrey(const std::filesystem::path& scene, const sim::ImportReport& import);

}  // namespace bulletnav::bench
