// SPDX-License-Identifier: MIT
#include "benchmark/report/run_scene.h"

#include "benchmark/base/file_hash.h"
#include "sim/base/error.h"

namespace bulletnav::bench {

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
