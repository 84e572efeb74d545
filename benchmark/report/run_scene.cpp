// SPDX-License-Identifier: MIT
#include "benchmark/report/run_scene.h"

#include <system_error>

#include "benchmark/base/file_hash.h"
#include "sim/base/error.h"
#include "sim/house/house_json.h"

namespace bulletnav::bench {

std::optional<sim::FloorPlan> PlanOfScene(const std::filesystem::path& scene, double scale) {
  const auto description = std::filesystem::path(scene).replace_extension(".json");
  std::error_code unreadable;
  if (scale != 1.0 || !std::filesystem::exists(description, unreadable)) return std::nullopt;
  return sim::ReadHouseJson(description).plan;
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
