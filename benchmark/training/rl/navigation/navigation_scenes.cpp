// SPDX-License-Identifier: MIT
#include "benchmark/training/rl/navigation/navigation_scenes.h"

#include <mutex>
#include <set>

#include "benchmark/episodes/scene_cache.h"
#include "sim/base/error.h"
#include "sim/math/rng.h"
#include "sim/threads/worker_pool.h"

namespace bulletnav::bench {
namespace {

constexpr std::array kKinds = {Difficulty::kEasy, Difficulty::kMedium, Difficulty::kHard};

sim::WorldOptions OptionsOf(const NavigationData& data, const std::filesystem::path& scene) {
  sim::WorldOptions options;
  options.import = data.import.options();
  options.backend = sim::Backend::kEmbree;  // the same pictures with and without a GPU
  if (data.looks) {
    options.import.finish = DrawLook(*data.looks, data.seed, scene.filename().string());
  }
  return options;
}

bool CanDraw(EpisodeDrawer* drawer, Difficulty kind) {
  try {
    drawer->Draw(kind, 0);
    return true;
  } catch (const sim::Error&) {
    return false;
  }
}

}  // namespace

void NavigationData::Validate() const {
  TrainingScenes::Validate();
  if (episodes < 0) throw sim::KeyError("episodes", "episodes must not be negative");
  if (plain_share < 0.0 || plain_share > 1.0) {
    throw sim::KeyError("plain_share", "plain_share must lie between 0 and 1");
  }
  if (plain_share == 0.0) return;
  if (!houses) throw sim::KeyError("plain_share", "plain_share is of 'houses'; name some");
  if (episodes > 0) {
    throw sim::KeyError("plain_share", "plain_share cannot be had with 'episodes'; leave one out");
  }
}

NavigationData PlainOf(const NavigationData& data) {
  NavigationData plain;
  if (data.plain_share > 0.0) plain.houses = data.houses;
  plain.import = data.import;
  return plain;
}

NavigationData ValidationOf(const std::optional<NavigationData>& validation,
                            const NavigationData& data) {
  if (validation) return *validation;
  NavigationData val;
  val.houses = data.houses;
  if (!val.houses) {
    throw sim::KeyError("validation",
                        "validation is missing; without houses there is no split to take it from");
  }
  val.houses->split = "val";
  val.seed = data.seed + 1;
  return val;
}

NavigationScenes::NavigationScenes(const NavigationData& data, const sim::BodySpec& body,
                                   int threads, const std::function<void()>& loaded,
                                   const Warn& warn)
    : seed_(data.seed), episodes_(data.episodes), plain_share_(data.plain_share) {
  const std::vector<std::filesystem::path> files = ScenesOf(data);
  if (files.empty()) throw sim::KeyError("data", "data names no scenes; see configs/train");
  const NavigationData plain = PlainOf(data);
  const std::vector<std::filesystem::path> plain_files = ScenesOf(plain);
  const std::set<std::filesystem::path> is_plain(plain_files.begin(), plain_files.end());
  scenes_.resize(files.size());
  std::mutex warning;
  const Warn warn_alone = [&](const std::string& text) {
    const std::lock_guard lock(warning);
    warn(text);
  };
  sim::WorkerPool pool(threads);
  pool.ForEach(static_cast<int>(files.size()), [&](int i, int) {
    Scene& scene = scenes_[static_cast<std::size_t>(i)];
    scene.file = files[static_cast<std::size_t>(i)];
    SceneCache cache(OptionsOf(data, scene.file));
    if (warn) cache.WarnOfGrey(warn_alone);
    cache.Expect(scene.file);
    scene.ground = cache.LoadGround(scene.file);
    scene.world = cache.Get(scene.file);
    scene.drawer = std::make_unique<EpisodeDrawer>(*scene.ground, scene.file.string(),
                                                   scene.ground->name, body, seed_);
    for (const Difficulty kind : kKinds) {
      if (CanDraw(scene.drawer.get(), kind)) scene.kinds.push_back(kind);
    }
    if (scene.kinds.empty()) {
      throw sim::FileError(scene.file, "", "has no place for an episode of 1.5 m or more");
    }
    cache.Done(scene.file);
    if (is_plain.contains(scene.file)) {
      scene.plain = sim::World::Load(scene.file, OptionsOf(plain, scene.file));
    }
    if (loaded) loaded();
  });
  for (Scene& scene : scenes_) {
    if (scene.plain) plain_.push_back(&scene);
  }
}

NavigationScenes::Drawn NavigationScenes::DrawIn(Scene* scene, Difficulty kind, int index) {
  Drawn drawn;
  drawn.episode.episode = scene->drawer->Draw(kind, index);
  drawn.episode.key = {"", "", "", seed_, scene->file.string(), drawn.episode.episode.id};
  drawn.episode.scene_file = scene->file;
  drawn.world = scene->world;
  return drawn;
}

NavigationScenes::Drawn NavigationScenes::Draw(int lane, std::uint64_t number) {
  sim::Rng rng = sim::Rng(seed_, "navigation")
                     .Fork("lane", static_cast<std::uint64_t>(lane))
                     .Fork("episode", number);
  if (episodes_ > 0) return DrawInTurn(static_cast<std::uint64_t>(rng.Below(episodes_)));
  const bool is_plain = plain_share_ > 0.0 && rng.Fork("plain", 0).Chance(plain_share_);
  const std::size_t count = is_plain ? plain_.size() : scenes_.size();
  const auto number_of = static_cast<std::size_t>(rng.Below(static_cast<int>(count)));
  Scene& scene = is_plain ? *plain_[number_of] : scenes_[number_of];
  const Difficulty kind =
      scene.kinds[static_cast<std::size_t>(rng.Below(static_cast<int>(scene.kinds.size())))];
  constexpr int kIndices = 1 << 30;
  Drawn drawn = DrawIn(&scene, kind, rng.Below(kIndices));
  if (is_plain) drawn.world = scene.plain;
  return drawn;
}

NavigationScenes::Drawn NavigationScenes::DrawInTurn(std::uint64_t number) {
  Scene& scene = scenes_[number % scenes_.size()];
  const std::uint64_t turn = number / scenes_.size();
  return DrawIn(&scene, scene.kinds[turn % scene.kinds.size()],
                static_cast<int>(turn / scene.kinds.size()));
}

}  // namespace bulletnav::bench
