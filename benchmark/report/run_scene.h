// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sim/house/floor_plan.h"
#include "sim/scene/doors.h"

namespace bulletnav::bench {

/// The plan of a generated house, from the description beside its mesh; absent if there is none or
/// the scene was scaled. `doors`: as ImportScene found or turned them. Throws sim::Error if it is
/// damaged.
std::optional<sim::FloorPlan> PlanOfScene(const std::filesystem::path& scene, double scale,
                                          const std::vector<sim::DoorLeaf>& doors);

/// The same for a drawing that can do without: a damaged description is told and left out.
std::optional<sim::FloorPlan> PlanOrWarning(const std::filesystem::path& scene, double scale,
                                            const std::vector<sim::DoorLeaf>& doors);

/// Throws sim::FileError if the file of a scene is not the one that a run was made in. `hashes`: of
/// scenes' contents by name, as in the `fingerprints` of the run's config.yaml; scenes that it does
/// not name pass.
void RequireSceneOfRun(const std::filesystem::path& file, const std::string& scene,
                       const std::map<std::string, std::string>& hashes);

}  // namespace bulletnav::bench
