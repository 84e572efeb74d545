// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>

#include "sim/scene/import.h"

namespace bulletnav::sim {

/// Drops from a y-up mesh in metres what no scene needs: triangles with NaN or infinite corners,
/// without area, repeated (in any winding), or stray far from all others; then unused vertices.
/// Adds a line to the report for each kind dropped.
/// Throws FileError, naming `file`, if over a tenth of the triangles has non-finite corners,
/// nothing is left, or the extent is not a building's (0.5 m to 2 km, within 10 km of the origin).
void CleanMesh(const std::filesystem::path& file, SceneMesh* mesh, ImportReport* report);

}  // namespace bulletnav::sim
