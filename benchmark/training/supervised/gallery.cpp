// SPDX-License-Identifier: MIT
#include "benchmark/training/supervised/gallery.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <map>
#include <vector>

#include "benchmark/training/supervised/sample_points.h"
#include "benchmark/training/supervised/scene_panoramas.h"
#include "benchmark/training/supervised/walk_grid.h"
#include "sim/base/check.h"
#include "sim/world.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;

constexpr int kGap = 4;  // pixels

/// The first places in a scene, as many as are asked for.
std::vector<sim::BodyPose> FirstPlaces(const fs::path& scene, int count, DataConfig config) {
  sim::WorldOptions options;
  options.import = config.import.options();
  options.navmesh = config.navmesh;
  options.backend = sim::Backend::kEmbree;
  const auto world = sim::World::Load(scene, options);
  world->RequireFloor();
  config.points = count;
  return DrawPoints(*world, LargestStorey(world->navmesh()), config);
}

}  // namespace

sim::Image DrawGallery(const DataConfig& config, int count,
                       const std::function<void()>& on_panorama) {
  BULLETNAV_CHECK(count >= 1);
  const std::vector<fs::path> scenes = ScenesOf(config);
  std::map<std::size_t, int> places;  // by scene: how many
  for (int i = 0; i < count; ++i) {
    ++places[static_cast<std::size_t>(i) * scenes.size() / static_cast<std::size_t>(count)];
  }
  const int cols = config.panorama.cols;
  const int rows = config.panorama.rows;
  sim::Image sheet(cols, count * (rows + kGap) - kGap, 3);
  std::fill(sheet.pixels.begin(), sheet.pixels.end(), std::uint8_t{255});
  int top = 0;
  for (const auto& [scene, n] : places) {
    const std::vector<sim::BodyPose> poses = FirstPlaces(scenes[scene], n, config);
    const auto seen = LoadForPanoramas(scenes[scene], config);
    ScenePanoramas panoramas(*seen, config);
    for (int place = 0; place < n; ++place) {
      panoramas.Render(poses, {&place, 1}, {sheet.at(0, top), 3 * config.panorama.pixels()}, {});
      top += rows + kGap;
      on_panorama();
    }
  }
  return sheet;
}

}  // namespace bulletnav::bench
