// SPDX-License-Identifier: MIT
#include "benchmark/episodes/scene_cache.h"

#include <utility>

#include "benchmark/base/file_hash.h"
#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;

std::size_t BytesOf(const sim::SceneMesh& mesh) {
  constexpr std::size_t kVertex =
      sizeof(Eigen::Vector3f) + sizeof(Eigen::Vector2f) + sizeof(sim::Rgb8);
  constexpr std::size_t kTriangle = 4 * sizeof(std::uint32_t);
  std::size_t bytes = mesh.positions.size() * kVertex + mesh.triangles.size() * kTriangle;
  for (const sim::Texture& texture : mesh.textures) bytes += texture.image.pixels.size();
  return bytes;
}

}  // namespace

SceneCache::SceneCache(const sim::WorldOptions& options, std::size_t most_bytes)
    : options_(options), most_bytes_(most_bytes) {}

SceneCache::Entry& SceneCache::Find(const fs::path& file) {
  const fs::path key = fs::weakly_canonical(file);
  const std::lock_guard lock(mutex_);
  return entries_[key];
}

SceneCache::Imported SceneCache::Import(const fs::path& file, Entry* entry) {
  if (entry->imported) return entry->imported;
  auto imported =
      std::make_shared<const sim::ImportedScene>(sim::ImportScene(file, options_.import));
  const std::string hash = FileHash(file);
  if (entry->hash.empty()) entry->hash = hash;
  if (entry->hash != hash) {
    throw sim::FileError(file, "", "has changed since this run began; run the same command again");
  }
  if (const std::string grey = DrawnGrey(file, imported->report);
      warn_ && !grey.empty() && !std::exchange(entry->has_warned, true)) {
    const std::lock_guard lock(warning_);
    warn_(grey);
  }
  const std::lock_guard lock(mutex_);
  ++imports_;
  return imported;
}

void SceneCache::Keep(const Imported& scene, Entry* entry) {
  if (entry->imported) return;
  const std::size_t bytes = BytesOf(scene->mesh);
  const std::lock_guard lock(mutex_);
  if (kept_bytes_ + bytes > most_bytes_) return;
  kept_bytes_ += bytes;
  entry->bytes = bytes;
  entry->imported = scene;
}

void SceneCache::WarnIfOpen(const fs::path& file, const sim::Navmesh& navmesh, Entry* entry) {
  if (!navmesh.is_open() || !warn_ || std::exchange(entry->has_warned_of_open, true)) return;
  const std::lock_guard lock(warning_);
  warn_(file.string() +
        ": nothing is indoors, so all that is level counts as floor, roofs too; if its floor is "
        "missing, give the block 'import' ground_plane: true, if it lies on its side, up: z");
}

void SceneCache::Drop(Entry* entry) {
  entry->imported.reset();
  const std::lock_guard lock(mutex_);
  kept_bytes_ -= std::exchange(entry->bytes, 0);
}

std::string SceneCache::HashOf(const fs::path& file) {
  Entry& entry = Find(file);
  const std::lock_guard lock(entry.loading);
  if (entry.hash.empty()) entry.hash = FileHash(file);
  return entry.hash;
}

std::unique_ptr<const Ground> SceneCache::LoadGround(const fs::path& file) {
  Entry& entry = Find(file);
  Imported scene;
  {
    const std::lock_guard lock(entry.loading);
    scene = Import(file, &entry);
    if (!entry.world) Keep(scene, &entry);
  }
  auto ground =
      std::make_unique<const Ground>(file.filename().string(), scene->mesh, options_.navmesh);
  sim::RequireFloor(file.string(), scene->report, ground->navmesh);
  WarnIfOpen(file, ground->navmesh, &entry);
  return ground;
}

void SceneCache::Expect(const fs::path& file) {
  Entry& entry = Find(file);
  const std::lock_guard lock(mutex_);
  ++entry.expected;
}

void SceneCache::DropOthers() {
  std::vector<Entry*> others;
  {
    const std::lock_guard lock(mutex_);
    for (auto& [file, entry] : entries_) {
      if (entry.expected == 0) others.push_back(&entry);
    }
  }
  for (Entry* entry : others) {
    const std::lock_guard lock(entry->loading);
    Drop(entry);
    entry->world.reset();
  }
}

std::shared_ptr<const sim::World> SceneCache::Get(const fs::path& file) {
  Entry& entry = Find(file);
  const std::lock_guard lock(entry.loading);
  if (!entry.world) {
    const Imported scene = Import(file, &entry);
    Drop(&entry);
    auto world = std::make_shared<const sim::World>(file.filename().string(), *scene, options_);
    world->RequireFloor();
    WarnIfOpen(file, world->navmesh(), &entry);
    entry.world = std::move(world);
  }
  return entry.world;
}

void SceneCache::Done(const fs::path& file) {
  Entry& entry = Find(file);
  const std::lock_guard lock(entry.loading);
  {
    const std::lock_guard counting(mutex_);
    if (--entry.expected > 0) return;
  }
  entry.world.reset();
}

int SceneCache::imports() const {
  const std::lock_guard lock(mutex_);
  return imports_;
}

std::size_t SceneCache::kept_bytes() const {
  const std::lock_guard lock(mutex_);
  return kept_bytes_;
}

}  // namespace bulletnav::bench
