// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "sim/scene/import.h"

namespace bulletnav::sim {

/// A scene and its report as bytes of this machine, and back. Not a file format: for handing a
/// scene from one process to another.
std::vector<std::uint8_t> ToBlob(const ImportedScene& scene);
/// Throws Error if the bytes end early or hold impossible lengths.
ImportedScene FromBlob(std::span<const std::uint8_t> blob);

}  // namespace bulletnav::sim
