// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "benchmark/episodes/drawn_grey.h"
#include "benchmark/episodes/ground.h"
#include "sim/world.h"

namespace bulletnav::bench {

/// The scenes of one process. Each is imported once, by the first who asks, whether to draw its
/// episodes, to check them or to play them. What was imported is kept until a world is made of it,
/// worlds until the last episode that is expected in them is done. Thread-safe.
/// An import is known by its file and the hash of its content: a file that is another when it is
/// imported again is refused. All members throw sim::FileError for a file that is no scene.
class SceneCache {
 public:
  /// Imports over `most_bytes` together are not kept: those scenes are imported again when they are
  /// played.
  explicit SceneCache(const sim::WorldOptions& options, std::size_t most_bytes = kMostBytes);

  /// From now on, `warn` is called once for each scene of which something is drawn grey, and once
  /// for each in which nothing is indoors, from any thread, one call at a time. To be called before
  /// scenes are loaded.
  void WarnOfGrey(Warn warn) { warn_ = std::move(warn); }

  /// FileHash of the file, which is read once.
  std::string HashOf(const std::filesystem::path& file);
  /// Throws sim::Error if the scene has next to no floor.
  std::unique_ptr<const Ground> LoadGround(const std::filesystem::path& file);

  /// One more episode will need the scene's world.
  void Expect(const std::filesystem::path& file);
  /// Drops what is kept of scenes in which no episode is expected.
  void DropOthers();
  /// Throws as LoadGround, and sim::RenderError.
  std::shared_ptr<const sim::World> Get(const std::filesystem::path& file);
  /// One episode that was expected is done.
  void Done(const std::filesystem::path& file);

  /// How often a file was imported.
  int imports() const;
  /// What is kept of imports, in bytes.
  std::size_t kept_bytes() const;

 private:
  static constexpr std::size_t kMostBytes = std::size_t{1} << 30;  // some 60 furnished houses
  struct Entry {
    std::mutex loading;
    std::string hash;
    std::shared_ptr<const sim::ImportedScene> imported;
    std::shared_ptr<const sim::World> world;
    std::size_t bytes = 0;  // of `imported`, while it is kept
    int expected = 0;
    bool has_warned = false;          // of what is drawn grey
    bool has_warned_of_open = false;  // that nothing is indoors
  };
  using Imported = std::shared_ptr<const sim::ImportedScene>;

  Entry& Find(const std::filesystem::path& file);
  /// Of an entry whose `loading` is held.
  Imported Import(const std::filesystem::path& file, Entry* entry);
  void Keep(const Imported& scene, Entry* entry);
  void WarnIfOpen(const std::filesystem::path& file, const sim::Navmesh& navmesh, Entry* entry);
  void Drop(Entry* entry);

  sim::WorldOptions options_;
  std::size_t most_bytes_;
  Warn warn_;
  std::mutex warning_;
  mutable std::mutex mutex_;  // of what follows, and of `bytes` and `expected` of entries
  std::size_t kept_bytes_ = 0;
  int imports_ = 0;
  std::map<std::filesystem::path, Entry> entries_;
};

}  // namespace bulletnav::bench
