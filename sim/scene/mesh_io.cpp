// SPDX-License-Identifier: MIT
#include "sim/scene/mesh_io.h"

#include <algorithm>

#include "sim/base/isolated.h"

namespace bulletnav::sim {
namespace {

constexpr int kSecondsAFile = 3;  // a small file may hold a picture of 64 million pixels
constexpr std::uintmax_t kSecondsAMegabyte = 2;
constexpr std::uintmax_t kMostSeconds = 1'000'000;

}  // namespace

int SecondsToRead(const std::filesystem::path& file) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  const std::uintmax_t seconds = error ? 0 : kSecondsAMegabyte * size >> 20;
  return kSecondsAFile + static_cast<int>(std::min(seconds, kMostSeconds));
}

bool MeshIo::Exists(const char* name) const {
  std::error_code ignored;
  return std::filesystem::is_regular_file(name, ignored);
}

Assimp::IOStream* MeshIo::Open(const char* name, const char* mode) {
  if (!Exists(name)) return nullptr;
  if (timed_.insert(name).second) AllowCpuSeconds(SecondsToRead(name));
  return DefaultIOSystem::Open(name, mode);
}

}  // namespace bulletnav::sim
