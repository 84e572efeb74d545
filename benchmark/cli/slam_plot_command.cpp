// SPDX-License-Identifier: MIT
// Pictures of a run of slam. It is in bulletnav-slam.so; see slam.h.
#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/core.h>

#include "benchmark/base/counted.h"
#include "benchmark/cli/slam_commands.h"
#include "benchmark/report/run_scene.h"
#include "benchmark/slam/plots/drive_figure.h"
#include "benchmark/slam/plots/heading_histogram.h"
#include "benchmark/slam/plots/matrix_figure.h"
#include "benchmark/slam/plots/room_figure.h"
#include "benchmark/slam/plots/sequence_figure.h"
#include "benchmark/slam/plots/slam_charts.h"
#include "benchmark/slam/runs/drive_files.h"
#include "benchmark/slam/runs/drive_frames.h"
#include "benchmark/slam/runs/drive_traces.h"
#include "benchmark/slam/runs/slam_runner.h"
#include "sim/base/error.h"
#include "sim/base/files.h"
#include "sim/image/image.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;

/// Whether a drive's folder has a file of each detector: .csv, the pairs that it took for loops, or
/// .tum, the trajectory with them.
bool KeepsAll(const SlamConfig& config, const fs::path& place, const std::string& ending) {
  return std::all_of(config.detectors.begin(), config.detectors.end(),
                     [&](const DetectorEntry& detector) {
                       return fs::exists(place / (detector.name + ending));
                     });
}

/// What a drive's folder holds: results that were copied or committed may lack trajectories.
DrivePicture PictureOf(const SlamConfig& config, const fs::path& folder) {
  DrivePicture picture;
  picture.truth = ReadTruth(folder);
  picture.panels.push_back({"odometry alone", ReadPoses(folder, "odometry"), {}});
  for (const DetectorEntry& detector : config.detectors) {
    if (!fs::exists(folder / (detector.name + ".tum"))) continue;
    picture.panels.push_back(
        {detector.name, ReadPoses(folder, detector.name), ReadLoops(folder, detector.name)});
  }
  return picture;
}

/// Counts a drive's accepted loops.
void CountHeadings(const SlamConfig& config, const fs::path& place,
                   std::vector<HeadingCounts>* counts) {
  for (std::size_t i = 0; i < config.detectors.size(); ++i) {
    for (const LoopRecord& loop : ReadLoops(place, config.detectors[i].name)) {
      if (loop.is_accepted) (*counts)[i].Add(loop.turned_deg, loop.is_wrong);
    }
  }
}

sim::Image Decoded(const fs::path& file) {
  try {
    return sim::DecodeImage(sim::ReadFile(file));
  } catch (const sim::ImageError& e) {
    throw sim::FileError(file, "",
                         std::string(e.what()) + "; remove the drive's folder and play it again");
  }
}

/// A grey picture of results; none where there is none.
sim::Image ReadGrey(const fs::path& file) {
  sim::Image grey;
  if (!fs::exists(file)) return grey;
  const sim::Image picture = Decoded(file);
  grey = sim::Image(picture.width, picture.height, 1);
  for (std::size_t i = 0; i < grey.pixels.size(); ++i) grey.pixels[i] = picture.pixels[4 * i];
  return grey;
}

/// Similarity of frames, and sequences where there are some; how many pictures.
std::size_t DrawFrames(const SlamConfig& config, const fs::path& place, const fs::path& stem,
                       const std::optional<SceneMap>& map) {
  std::vector<MatrixPanel> matrices;
  std::vector<SequencePanel> sequences;
  for (const DetectorEntry& detector : config.detectors) {
    matrices.push_back({detector.name, ReadGrey(place / (detector.name + ".similarity.png"))});
    agent::SequenceTrace trace = ReadTrace(place, detector.name);
    if (!trace.sequences.empty()) sequences.push_back({detector.name, std::move(trace)});
  }
  matrices.push_back({"covisible", ReadGrey(place / "covisible.png")});
  const auto truth = ReadTruth(place);
  WriteFigure(MatrixFigure(matrices, ReadDriveResult(place).frames), stem.string() + "_similarity");
  if (sequences.empty()) return 1;
  WriteFigure(ElbowFigure(sequences), stem.string() + "_elbow");
  if (truth.empty()) return 2;
  WriteFigure(SequenceFigure(truth, sequences, map), stem.string() + "_sequences");
  if (!map || !map->plan) return 3;
  WriteFigure(RoomFigure(truth, sequences, *map->plan), stem.string() + "_rooms");
  return 4;
}

/// The plans of scenes; all drives of one come one after the other.
class ScenePlans {
 public:
  explicit ScenePlans(const SlamConfig& config) : options_(WorldOptionsOf(config.import)) {}

  /// None of a recording, or where the scene is gone or not known. Good until the next call.
  const std::optional<SceneMap>& Of(const Drive& drive) {
    if (drive.source == source_) return map_;
    source_ = drive.source;
    map_.reset();
    if (drive.is_recording || !fs::exists(source_)) return map_;
    const auto imported = sim::ImportScene(source_, options_.import);
    map_ = MakeSceneMap(imported.mesh, sim::Navmesh(imported.mesh, options_.navmesh),
                        PlanOrWarning(source_, options_.import.scale, imported.doors));
    return map_;
  }

 private:
  sim::WorldOptions options_;
  fs::path source_;
  std::optional<SceneMap> map_;
};

}  // namespace

void DrawSlamRun(const fs::path& folder, SlamPictures pictures) {
  const SlamConfig config = ReadSlamRun(folder);
  const auto results = ReadSlamResults(config, folder);
  const fs::path plots = folder / "plots";
  WriteFigure(PrecisionRecallFigure(config, results), plots / "precision_recall");
  WriteFigure(HeadingFigure(config, results), plots / "headings");
  std::size_t drawn = 2;
  std::size_t bare = 0;
  std::size_t without_loops = 0;
  std::vector<HeadingCounts> headings(config.detectors.size());
  for (std::size_t i = 0; i < headings.size(); ++i) headings[i].name = config.detectors[i].name;
  ScenePlans plans(config);
  for (const Drive& drive : DrivesDone(config, folder)) {
    const fs::path place = DriveFolder(folder, drive.name);
    if (KeepsAll(config, place, ".csv")) {
      CountHeadings(config, place, &headings);
    } else {
      ++without_loops;
    }
    if (pictures == SlamPictures::kCharts) continue;
    const bool has_odometry = fs::exists(place / "odometry.tum");
    if (!has_odometry || !KeepsAll(config, place, ".tum")) ++bare;
    if (!has_odometry) continue;
    const std::optional<SceneMap>& map = plans.Of(drive);
    WriteFigure(DriveFigure(PictureOf(config, place), map), plots / drive.name);
    drawn += 1 + DrawFrames(config, place, plots / drive.name, map);
  }
  if (without_loops == 0) {
    WriteFigure(HeadingHistogram(headings), plots / "loops_by_heading");
    ++drawn;
  } else {
    fmt::print(stderr,
               "note: {} of {} drives do not keep their pairs, so that loops by heading "
               "are not drawn\n",
               without_loops, results.size());
  }
  if (bare > 0) {
    fmt::print(stderr,
               "note: {} of {} drives do not keep all their trajectories, so that those they "
               "lack are not drawn\n",
               bare, results.size());
  }
  fmt::print(stderr, "{} in {}\n", Counted(drawn, "picture"), plots.string());
}

void AddSlamPlotCommand(CLI::App* slam) {
  struct Options {
    fs::path folder;
    bool charts = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = slam->add_subcommand(
      "plot", "Draw a run's precision over recall, loops by heading, and trajectories");
  command->add_option("run", options->folder, "Folder of results of slam run")->required();
  command->add_flag("--charts", options->charts, "Only what is of all drives together");
  command->callback([options] {
    DrawSlamRun(options->folder, options->charts ? SlamPictures::kCharts : SlamPictures::kAll);
  });
}

}  // namespace bulletnav::bench
