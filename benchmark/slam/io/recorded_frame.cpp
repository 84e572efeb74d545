// SPDX-License-Identifier: MIT
#include "benchmark/slam/io/recorded_frame.h"

#include "sim/base/error.h"

namespace bulletnav::bench {

void ExpectNoRecording(const std::filesystem::path& folder) {
  for (const char* list : {"rgb.txt", "times.txt"}) {
    if (std::filesystem::exists(folder / list)) {
      throw sim::FileError(
          folder, "", std::string("holds a recording already (") + list + "); name another folder");
    }
  }
}

void ExpectNoResults(const std::filesystem::path& folder) {
  if (std::filesystem::exists(folder / "config.yaml")) {
    throw sim::FileError(folder, "", "holds results (config.yaml); name another folder");
  }
}

}  // namespace bulletnav::bench
