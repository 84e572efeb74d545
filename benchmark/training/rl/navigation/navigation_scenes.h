// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "benchmark/episodes/drawn_grey.h"
#include "benchmark/episodes/episode_drawer.h"
#include "benchmark/episodes/import_spec.h"
#include "benchmark/play/task_episode.h"
#include "benchmark/training/core/training_scenes.h"
#include "benchmark/training/supervised/looks.h"
#include "sim/world.h"

namespace bulletnav::bench {

/// The scenes that a policy is trained in, or tried in: the block `data` of a training's config.
struct NavigationData : TrainingScenes {
  ImportSpec import;  // of all scenes
  /// How scenes are drawn, each in one look for the whole training; bodies walk in them as they
  /// are. Absent: as their files say.
  std::optional<LooksSpec> looks;
  double plain_share = 0.0;  // of the episodes: in `houses` as they are, whatever the looks
  std::uint64_t seed = 0;    // of the episodes and the looks
  int episodes = 0;          // always the first so many of DrawInTurn; 0: others without end

  template <class V>
  void Visit(V& v) {
    TrainingScenes::Visit(v);
    v("import", import);
    v("looks", looks);
    v("plain_share", plain_share);
    v("seed", seed);
    v("episodes", episodes);
  }
  /// Throws Error.
  void Validate() const;
};

/// The houses that `data` wants as they are, and nothing else; none without plain_share.
NavigationData PlainOf(const NavigationData& data);

/// `validation` if it is given, else the houses' split "val" of the training's `data`. Throws
/// KeyError if there is neither.
NavigationData ValidationOf(const std::optional<NavigationData>& validation,
                            const NavigationData& data);

/// Scenes in memory with all episodes that can be drawn in them: easy, medium and hard ones in
/// equal shares, as far as a scene has them.
class NavigationScenes {
 public:
  /// Loads all of them. `loaded` is called after each, `warn` once for each that is drawn grey (see
  /// SceneCache), from any thread. Throws sim::Error for a scene that cannot be loaded, or that
  /// has no episodes.
  NavigationScenes(const NavigationData& data, const sim::BodySpec& body, int threads,
                   const std::function<void()>& loaded = {}, const Warn& warn = {});

  struct Drawn {
    EpisodeTask episode;
    std::shared_ptr<const sim::World> world;
  };
  /// Episode `number` of a lane; another for each pair, or one of those that there are. Not from
  /// several threads at once.
  Drawn Draw(int lane, std::uint64_t number);
  /// Episode `number` of a kind, each scene in turn, its kinds in turn.
  Drawn DrawInTurn(std::uint64_t number);

  std::size_t count() const { return scenes_.size(); }
  /// The houses that are kept as they are beside those with looks.
  std::size_t plain_count() const { return plain_.size(); }

 private:
  struct Scene {
    std::filesystem::path file;
    std::unique_ptr<const Ground> ground;
    std::shared_ptr<const sim::World> world;
    std::unique_ptr<EpisodeDrawer> drawer;
    std::vector<Difficulty> kinds;
    std::shared_ptr<const sim::World> plain;  // as it is, of houses where plain_share wants them
  };
  Drawn DrawIn(Scene* scene, Difficulty kind, int index);

  std::uint64_t seed_;
  int episodes_;
  double plain_share_;
  std::vector<Scene> scenes_;
  std::vector<Scene*> plain_;  // those that have a plain world
};

}  // namespace bulletnav::bench
