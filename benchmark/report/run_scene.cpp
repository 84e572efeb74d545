// SPDX-License-Identifier: MIT
#include "benchmark/report/run_scene.h"

#include <system_error>

#include "benchmark/base/file_hash.h"
#include "benchmark/base/warn_line.h"
#include "sim/base/error.h"
#include "sim/house/house_json.h"
#include "sim/house/turn_leaves.h"

namespace bulletnav::bench {

std::optional<sim::FloorPlan> PlanOfScene(const std::filesystem::path& scene, double scale,
                                          const std::vector<sim::DoorLeaf>& doors) {
  const auto description = std::filesystem::path(scene).replace_extension(".json");
  std::error_code unreadable;
  if (scale != 1.0 || !std::filesystem::exists(description, unreadable)) return std::nullopt;
  sim::FloorPlan plan = sim::ReadHouseJson(description).plan;
  sim::TurnLeaves(doors, &plan);
  return plan;
}

std::optional<sim::FloorPlan> PlanOrWarning(const std::filesystem::path& scene, double scale,
                                            const std::vector<sim::DoorLeaf>& doors) {
  try {
    return PlanOfScene(scene, scale, doors);
  } catch (const sim::Error& e) {
    WarnLine(std::string("drawn without the house's plan: ") + e.what());
    return std::nullopt;
  }
}

void RequireSceneOfRun(const std::filesystem::path& file, const std::string& scene,
                       const std::map<std::string, std::string>& hashes) {
  const auto saved = hashes.find(scene);
  if (saved == hashes.end()) return;
  if (FileHash(file) == saved->second) return;
  throw sim::FileError(file, "",
                       "has changed since the run, whose paths do not fit it; put back the scene "
                       "of the run, or run again into another folder");
}

}  // namespace bulletnav::bench
