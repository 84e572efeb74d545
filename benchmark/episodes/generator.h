// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "benchmark/base/warn_line.h"
#include "benchmark/episodes/episode.h"
#include "benchmark/episodes/import_spec.h"
#include "sim/navmesh/navmesh.h"
#include "sim/physics/body_spec.h"

namespace bulletnav::bench {

class SceneCache;

/// The houses of one split of an index that the house generator wrote.
struct HouseSelection {
  std::string index;
  std::string split = "test";

  template <class V>
  void Visit(V& v) {
    v.Required("index", index);
    v("split", split);
  }
};

/// How many episodes, over all scenes together.
struct EpisodeCounts {
  int easy = 0;
  int medium = 0;
  int hard = 0;
  int sequential = 0;
  // Not in records of how a set was drawn unless they are given.
  std::optional<int> very_hard = {};
  std::optional<int> extreme = {};

  template <class V>
  void Visit(V& v) {
    v("easy", easy);
    v("medium", medium);
    v("hard", hard);
    v("sequential", sequential);
    v("very_hard", very_hard);
    v("extreme", extreme);
  }
  void Validate() const;
};

/// A set of episodes to draw: the config of `bulletnav episodes generate`.
struct GeneratorSpec {
  std::vector<std::string> scenes;       // mesh files, or folders of them
  std::optional<HouseSelection> houses;  // in addition
  ImportSpec import;                     // of all scenes
  EpisodeCounts counts;
  int sequential_goals = 10;
  std::uint64_t seed = 0;
  sim::BodySpec body;
  sim::NavmeshSpec navmesh;
  std::string out;

  template <class V>
  void Visit(V& v) {
    v("scenes", scenes);
    v("houses", houses);
    v("import", import);
    v("counts", counts);
    v("sequential_goals", sequential_goals);
    v("seed", seed);
    v("body", body);
    v("navmesh", navmesh);
    v.Required("out", out);
  }
  void Validate() const;
};

/// The mesh files that a spec names, all that lie below a folder that it names (of scans that are
/// there in several forms, as HM3D's, the one with colours that can be read), houses last. Throws
/// sim::FileError for a folder without meshes, sim::Error for an index that is damaged or
/// has no house in the split.
std::vector<std::string> ScenesOf(const GeneratorSpec& spec);

/// Warns if there are more scenes than episodes.
void WarnOfScenesLeftOut(const GeneratorSpec& spec, const std::vector<std::string>& scenes,
                         const Warn& warn);

/// Draws all episodes (see EpisodeDrawer), spread evenly over the scenes: scene s of n gets
/// count / n of a kind, and one more if s < count % n; where count < n, the next ones get one after
/// those that got one of the kind before. They come by index, then kind, then scene, so that any
/// first part of the list is spread evenly too. The same for any number of workers, which take a
/// scene each; `workers` < 1: one per processor. `on_scene` is called, from any thread, when a
/// scene is done. `cache`, if given, loads the scenes, as the spec says, and keeps them for who
/// plays them. Throws sim::Error for a scene that cannot be loaded or has no such episodes.
std::vector<Episode> GenerateEpisodes(const GeneratorSpec& spec,
                                      const std::vector<std::string>& scenes, int workers,
                                      const std::function<void()>& on_scene = {},
                                      SceneCache* cache = nullptr);

}  // namespace bulletnav::bench
