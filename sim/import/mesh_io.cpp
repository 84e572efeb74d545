// SPDX-License-Identifier: MIT
#include "sim/import/mesh_io.h"

#include <algorithm>

#include <assimp/MemoryIOWrapper.h>

#include "sim/import/cpu_time.h"
#include "sim/import/uri.h"

namespace bulletnav::sim {
namespace {

constexpr int kSecondsAFile = 3;
constexpr std::uintmax_t kSecondsAMegabyte = 2;
constexpr std::uintmax_t kMostSeconds = 1'000'000;

std::optional<std::filesystem::path> FindRegularFile(const std::filesystem::path& path) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(path, ignored) ? std::optional(path) : std::nullopt;
}

}  // namespace

int SecondsToRead(const std::filesystem::path& file) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  const std::uintmax_t seconds = error ? 0 : kSecondsAMegabyte * size >> 20;
  return kSecondsAFile + static_cast<int>(std::min(seconds, kMostSeconds));
}

/// assimp puts the mesh's folder before names; percent signs in that are its own.
std::optional<std::filesystem::path> MeshIo::Find(const std::string& name) const {
  if (auto as_it_stands = FindRegularFile(name)) return as_it_stands;
  const std::string folder = folder_.empty() ? "" : (folder_ / "").string();
  if (!name.starts_with(folder)) return std::nullopt;
  return FindByUri(folder_, name.substr(folder.size()));
}

std::span<const std::uint8_t> MeshIo::InPlaceOf(const std::string& name) const {
  if (name == mesh_) return checked_.content;
  const bool is_decoded = std::filesystem::path(name).filename() == kDecodedBuffer;
  return is_decoded ? std::span<const std::uint8_t>(checked_.decoded)
                    : std::span<const std::uint8_t>();
}

bool MeshIo::Exists(const char* name) const {
  return !InPlaceOf(name).empty() || Find(name).has_value();
}

Assimp::IOStream* MeshIo::Open(const char* name, const char* mode) {
  if (const std::span<const std::uint8_t> content = InPlaceOf(name); !content.empty()) {
    // NOLINTNEXTLINE(cppcoreguidelines-owning-memory): assimp closes it
    return new Assimp::MemoryIOStream(content.data(), content.size());
  }
  const auto path = Find(name);
  if (!path) return nullptr;
  if (timed_.insert(path->string()).second) AllowCpuSeconds(SecondsToRead(*path));
  return DefaultIOSystem::Open(path->c_str(), mode);
}

}  // namespace bulletnav::sim
