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
#include "benchmark/slam/io/file_frames.h"
#include "benchmark/slam/plots/drive_figure.h"
#include "benchmark/slam/plots/slam_charts.h"
#include "benchmark/slam/runs/drive_files.h"
#include "benchmark/slam/runs/drive_frames.h"
#include "benchmark/slam/runs/slam_runner.h"
#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;

std::vector<sim::PlanarPose> PlanarPoses(const fs::path& file) {
  std::vector<sim::PlanarPose> poses;
  for (const TimedPose& pose : ReadTumTrajectory(file)) poses.push_back(PlanarFromFile(pose.pose));
  return poses;
}

/// What a drive's folder holds.
DrivePicture PictureOf(const SlamConfig& config, const fs::path& folder) {
  DrivePicture picture;
  if (fs::exists(folder / "groundtruth.tum")) {
    for (const TimedPose& pose : ReadTumTrajectory(folder / "groundtruth.tum")) {
      picture.truth.push_back(BodyFromFile(pose.pose, 0.0));
    }
  }
  picture.panels.push_back({"odometry alone", PlanarPoses(folder / "odometry.tum"), {}});
  for (const DetectorEntry& detector : config.detectors) {
    picture.panels.push_back({detector.name, PlanarPoses(folder / (detector.name + ".tum")),
                              ReadLoops(folder / (detector.name + ".csv"))});
  }
  return picture;
}

/// The plan of a drive's scene; none of a recording, or where the scene is gone.
std::optional<SceneMap> MapOf(const SlamConfig& config, const Drive& drive) {
  if (drive.is_recording || !fs::exists(drive.source)) return std::nullopt;
  const auto world = sim::World::Load(drive.source, WorldOptionsOf(config));
  const auto imported = sim::ImportScene(drive.source, config.import.options());
  return MakeSceneMap(imported.mesh, world->navmesh(), std::nullopt);
}

}  // namespace

void DrawSlamRun(const fs::path& folder) {
  const SlamConfig config = ReadSlamRun(folder);
  const auto results = ReadSlamResults(config, folder);
  const fs::path plots = folder / "plots";
  WriteFigure(PrecisionRecallFigure(config, results), plots / "precision_recall");
  WriteFigure(HeadingFigure(config, results), plots / "headings");
  std::size_t drawn = 2;
  for (const Drive& drive : DrivesOf(config)) {
    const fs::path place = DriveFolder(folder, drive.name);
    if (!HasDrive(place)) continue;
    WriteFigure(DriveFigure(PictureOf(config, place), MapOf(config, drive)), plots / drive.name);
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
