// SPDX-License-Identifier: MIT
#include "benchmark/base/file_hash.h"

#include <fmt/core.h>

#include "sim/base/files.h"

namespace bulletnav::bench {

std::string FileHash(const std::filesystem::path& file) {
  return fmt::format("{:016x}", sim::Hash64(sim::ReadFile(file)));
}

}  // namespace bulletnav::bench
