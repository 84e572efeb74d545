// SPDX-License-Identifier: MIT
#include <algorithm>
#include <memory>
#include <mutex>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/core.h>

#include "benchmark/base/program_version.h"
#include "benchmark/cli/commands.h"
#include "benchmark/cli/progress.h"
#include "benchmark/cli/shipped_config.h"
#include "benchmark/cli/stop_note.h"
#include "benchmark/training/supervised/data_config.h"
#include "benchmark/training/supervised/dataset.h"
#include "benchmark/training/supervised/gallery.h"
#include "benchmark/training/supervised/label_picture.h"
#include "benchmark/training/supervised/label_statistics.h"
#include "sim/base/error.h"
#include "sim/base/files.h"
#include "sim/base/require_writable.h"
#include "sim/image/image.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;

struct DatasetOptions {
  fs::path config;
  int workers = 0;
  fs::path draw;
  std::string scene;
  int count = 4;
  fs::path gallery;
  int panoramas = 16;
};

void MakeHousesFor(const DataConfig& config, int workers) {
  const std::string version = CommittedVersion();
  const StopNote note([&]() -> std::string {
    if (version.empty()) return "";
    return "houses that are done stay; the same command goes on from there";
  });
  MakeHousesOf(config, version, workers, StartLine);
}

void MakeLabels(const DataConfig& config, int workers) {
  LabelStatistics statistics;
  int cached = 0;
  Progress progress("scenes", static_cast<int>(ScenesOf(config).size()));
  std::mutex mutex;
  const StopNote note([&] {
    return "labels of scenes that are done stay in " + config.cache +
           "; the same command goes on from there";
  });
  LabelScenes(config, workers, [&](const LabelledScene& scene) {
    const std::lock_guard lock(mutex);
    if (!scene.note.empty()) fmt::print(stderr, "{}\n", scene.note);
    cached += scene.was_cached ? 1 : 0;
    statistics.Add(scene.samples);
    progress.Advance();
  });
  fmt::print("{}{} scenes had their labels in {} already\n", statistics.ToText(), cached,
             config.cache);
}

/// The scene of the config with this file name; the first one if the name is empty.
fs::path FindScene(const DataConfig& config, const DatasetOptions& options) {
  const std::string& name = options.scene;
  const std::vector<fs::path> scenes = ScenesOf(config);
  const auto found = std::find_if(scenes.begin(), scenes.end(), [&](const fs::path& scene) {
    return name.empty() || scene == name || scene.filename() == name;
  });
  if (found == scenes.end()) {
    throw sim::FileError(options.config, "data",
                         fmt::format("has no scene '{}'; its {} scenes begin with {}", name,
                                     scenes.size(), scenes.front().filename().string()));
  }
  return *found;
}

void Draw(const DataConfig& config, const DatasetOptions& options) {
  const fs::path scene = FindScene(config, options);
  const LabelledScene labelled = LabelScene(scene, config);
  if (!labelled.note.empty()) fmt::print(stderr, "{}\n", labelled.note);
  const int count = std::min(options.count, labelled.samples.count());
  for (const fs::path& file : DrawLabels(labelled, config, count, options.draw)) {
    fmt::print("{}\n", file.string());
  }
}

void WriteGallery(const DataConfig& config, const DatasetOptions& options) {
  constexpr int kQuality = 75;
  Progress progress("panoramas", options.panoramas);
  const sim::Image sheet = DrawGallery(config, options.panoramas, [&] {
    progress.Advance();
  });
  sim::WriteFileAtomically(options.gallery, sim::EncodeJpeg(sheet, kQuality));
  fmt::print("{}\n", options.gallery.string());
}

/// What cannot be written is told before the work.
void RequirePlaces(const DataConfig& config, const DatasetOptions& options) {
  if (!options.gallery.empty()) {
    sim::RequireWritable(options.gallery);
    return;
  }
  sim::RequireWritable(fs::path(config.cache) / "writable");
  if (!options.draw.empty()) sim::RequireWritable(options.draw / "writable");
}

std::string RequireJpeg(const std::string& file) {
  return file.ends_with(".jpg") || file.ends_with(".jpeg") ? "" : file + " must end in .jpg";
}

}  // namespace

void AddDatasetCommand(CLI::App* program) {
  auto options = std::make_shared<DatasetOptions>();
  CLI::App* command = program->add_subcommand(
      "dataset", "Label the training scenes for the learned functions of Neural Topological SLAM");
  command
      ->add_option("config", options->config,
                   "YAML file with a block 'data', as configs/train/data.yaml")
      ->required();
  command->add_option("--workers", options->workers, "Threads (default: one per processor)")
      ->check(CLI::Range(1, 1024));
  auto* draw = command->add_option(
      "--draw", options->draw, "Folder for pictures of some points of one scene; label no more");
  command->add_option("--scene", options->scene, "Scene to draw (default: the first)")->needs(draw);
  command->add_option("--count", options->count, "Points to draw")
      ->needs(draw)
      ->check(CLI::Range(1, 2000));
  auto* gallery =
      command->add_option("--gallery", options->gallery,
                          "JPEG of panoramas of some scenes, each in its look; label no more");
  gallery->excludes(draw)->check(RequireJpeg);
  command->add_option("--panoramas", options->panoramas, "Panoramas in the gallery")
      ->needs(gallery)
      ->check(CLI::Range(1, 200));
  command->callback([options] {
    const DataConfig config = LoadDataConfig(ShippedConfig(options->config));
    RequirePlaces(config, *options);
    MakeHousesFor(config, options->workers);
    if (!options->gallery.empty()) {
      WriteGallery(config, *options);
    } else if (options->draw.empty()) {
      MakeLabels(config, options->workers);
    } else {
      Draw(config, *options);
    }
  });
}

}  // namespace bulletnav::bench
