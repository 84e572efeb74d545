// SPDX-License-Identifier: MIT
#include "benchmark/training/supervised/gallery.h"

#include <algorithm>
#include <vector>

#include "benchmark/training/supervised/sample_points.h"
#include "benchmark/training/supervised/scene_panoramas.h"
#include "benchmark/training/supervised/walk_grid.h"
#include "sim/world.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;

constexpr int kColumns = 2;
constexpr int kGap = 4;  // pixels

sim::Image FirstPanorama(const fs::path& scene, const DataConfig& config) {
  sim::WorldOptions options;
  options.import = config.import.options();
  options.navmesh = config.navmesh;
  options.backend = sim::Backend::kEmbree;
  DataConfig one = config;
  one.points = 1;
  std::vector<sim::BodyPose> poses;
  {
    const auto world = sim::World::Load(scene, options);
    world->RequireFloor();
    poses = DrawPoints(*world, LargestStorey(world->navmesh()), one);
  }
  const auto seen = LoadForPanoramas(scene, config);
  sim::Image image(config.panorama.cols, config.panorama.rows, 3);
  constexpr int kFirst = 0;
  ScenePanoramas(*seen, config).Render(poses, {&kFirst, 1}, image.pixels, {});
  return image;
}

void Paste(const sim::Image& image, int left, int top, sim::Image* sheet) {
  for (int y = 0; y < image.height; ++y) {
    std::copy_n(image.at(0, y), 3 * image.width, sheet->at(left, top + y));
  }
}

}  // namespace

sim::Image DrawGallery(const DataConfig& config, int count, const std::function<void()>& on_scene) {
  const std::vector<fs::path> scenes = ScenesOf(config);
  const int n = std::min(count, static_cast<int>(scenes.size()));
  const int rows = (n + kColumns - 1) / kColumns;
  const int width = config.panorama.cols + kGap;
  const int height = config.panorama.rows + kGap;
  sim::Image sheet(std::min(n, kColumns) * width - kGap, rows * height - kGap, 3);
  std::fill(sheet.pixels.begin(), sheet.pixels.end(), std::uint8_t{255});
  for (int i = 0; i < n; ++i) {
    const auto scene = static_cast<std::size_t>(i) * scenes.size() / static_cast<std::size_t>(n);
    Paste(FirstPanorama(scenes[scene], config), i % kColumns * width, i / kColumns * height,
          &sheet);
    on_scene();
  }
  return sheet;
}

}  // namespace bulletnav::bench
