// SPDX-License-Identifier: MIT
// Pictures of a run of slam. It is in bulletnav-slam.so; see slam.h.
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/core.h>

#include "benchmark/base/counted.h"
#include "benchmark/cli/slam_commands.h"
#include "benchmark/slam/plots/drive_figure.h"
#include "benchmark/slam/plots/slam_charts.h"
#include "benchmark/slam/runs/drive_files.h"
#include "benchmark/slam/runs/drive_frames.h"
#include "benchmark/slam/runs/slam_runner.h"
#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;

/// What a drive's folder holds.
DrivePicture PictureOf(const SlamConfig& config, const fs::path& folder) {
  DrivePicture picture;
  picture.truth = ReadTruth(folder);
  picture.panels.push_back({"odometry alone", ReadPoses(folder, "odometry"), {}});
  for (const DetectorEntry& detector : config.detectors) {
    picture.panels.push_back(
        {detector.name, ReadPoses(folder, detector.name), ReadLoops(folder, detector.name)});
  }
  return picture;
}

/// The plans of scenes; all drives of one come one after the other.
class ScenePlans {
 public:
  explicit ScenePlans(const SlamConfig& config) : options_(WorldOptionsOf(config)) {}

  /// None of a recording, or where the scene is gone. Good until the next call.
  const std::optional<SceneMap>& Of(const Drive& drive) {
    if (drive.source == source_) return map_;
    source_ = drive.source;
    map_.reset();
    if (drive.is_recording || !fs::exists(source_)) return map_;
    const auto imported = sim::ImportScene(source_, options_.import);
    map_ = MakeSceneMap(imported.mesh, sim::Navmesh(imported.mesh, options_.navmesh), std::nullopt);
    return map_;
  }

 private:
  sim::WorldOptions options_;
  fs::path source_;
  std::optional<SceneMap> map_;
};

}  // namespace

void DrawSlamRun(const fs::path& folder) {
  const SlamConfig config = ReadSlamRun(folder);
  const auto results = ReadSlamResults(config, folder);
  const fs::path plots = folder / "plots";
  WriteFigure(PrecisionRecallFigure(config, results), plots / "precision_recall");
  WriteFigure(HeadingFigure(config, results), plots / "headings");
  std::size_t drawn = 2;
  ScenePlans plans(config);
  for (const Drive& drive : DrivesOf(config)) {
    const fs::path place = DriveFolder(folder, drive.name);
    if (!HasDrive(place)) continue;
    WriteFigure(DriveFigure(PictureOf(config, place), plans.Of(drive)), plots / drive.name);
    ++drawn;
  }
  fmt::print(stderr, "{} in {}\n", Counted(drawn, "picture"), plots.string());
}

void AddSlamPlotCommand(CLI::App* slam) {
  auto folder = std::make_shared<fs::path>();
  CLI::App* command = slam->add_subcommand(
      "plot", "Draw a run's precision over recall, loops by heading, and trajectories");
  command->add_option("run", *folder, "Folder of results of slam run")->required();
  command->callback([folder] {
    DrawSlamRun(*folder);
  });
}

}  // namespace bulletnav::bench
