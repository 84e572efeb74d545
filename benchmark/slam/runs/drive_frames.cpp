// SPDX-License-Identifier: MIT
#include "benchmark/slam/runs/drive_frames.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include <fmt/core.h>

#include "benchmark/slam/io/file_frames.h"
#include "benchmark/slam/io/recording_check.h"
#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;

/// By frame; none where all cameras are level and at one height.
std::vector<std::optional<CameraTilt>> TiltsOf(
    std::span<const std::optional<agent::SpatialPose>> truth) {
  constexpr double kLevel = 1e-4;  // radians, metres: as files are rounded
  std::vector<std::optional<CameraTilt>> tilts(truth.size());
  const CameraTilt* first = nullptr;
  bool is_level = true;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (!truth[i]) continue;
    tilts[i] = CameraTilt{LevelFromCamera(*truth[i]), truth[i]->position.z()};
    if (first == nullptr) first = &*tilts[i];
    is_level = is_level && std::abs(tilts[i]->height - first->height) < kLevel &&
               (tilts[i]->level_from_camera - Eigen::Matrix3d::Identity()).norm() < kLevel;
  }
  if (is_level) tilts.assign(truth.size(), std::nullopt);
  return tilts;
}

/// What the scene of a drive becomes.
ChangedScene ChangedOf(const SlamConfig& config, const Drive& drive) {
  const ChangeSpec& spec = *config.changed;
  sim::WorldOptions options = WorldOptionsOf(config.import);
  if (spec.finish) options.import.finish = *spec.finish;
  fs::path source = drive.source;
  if (spec.houses) {
    source = fs::path(spec.houses->folder) / source.filename();
    if (!fs::exists(source)) {
      throw sim::FileError(source, "",
                           "is not there: 'changed.houses' must have a house for each that is "
                           "driven through, of the same name");
    }
  }
  ChangedScene changed;
  changed.world = sim::World::Load(source, options);
  changed.from_step = static_cast<int>(spec.from * drive.actions);
  changed.is_refurnished = spec.houses.has_value();
  return changed;
}

}  // namespace

TraversalSpec TraversalOf(const SlamConfig& config, int actions, std::uint64_t seed) {
  TraversalSpec traversal;
  traversal.body = config.body;
  traversal.camera = config.camera;
  traversal.panorama = config.panorama;
  traversal.noise = config.noise;
  traversal.sensor_noise = config.sensor_noise.value_or("none");
  traversal.actions = actions;
  traversal.seed = seed;
  return traversal;
}

CameraLens LensOf(const TraversalSpec& traversal) {
  if (const auto& panorama = traversal.panorama) {
    return agent::PanoramaLens::Of(panorama->rows, panorama->cols);
  }
  return IntrinsicsOf(traversal.camera);
}

sim::WorldOptions WorldOptionsOf(const ImportSpec& import) {
  sim::WorldOptions options;
  options.import = import.options();
  options.backend = sim::Backend::kEmbree;
  return options;
}

DriveSource::DriveSource(const SlamConfig& config, const Drive& drive) {
  if (drive.is_recording) {
    recording_ = Read(drive.source);
  } else {
    traversal_ = TraversalOf(config, drive.actions, drive.seed);
    world_ = sim::World::Load(drive.source, WorldOptionsOf(config.import));
    if (config.changed) changed_ = ChangedOf(config, drive);
  }
}

DriveSource::Recording DriveSource::Read(const fs::path& folder) {
  Recording recording;
  recording.place = folder;
  recording.folder = ReadTumFolder(folder, {});
  std::vector<double> times;
  for (const TumFrame& frame : recording.folder.frames) times.push_back(frame.time);
  const fs::path odometry = folder / "odometry.txt";
  if (!fs::exists(odometry)) {
    throw sim::FileError(odometry, "",
                         "is not there; write the odometry added up as 't x y z qx qy qz qw' of "
                         "the camera, a line a frame");
  }
  const auto measured = PosesAt(times, ReadTumTrajectory(odometry), kPoseApart);
  recording.odometry.reserve(times.size());
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (!measured[i]) {
      throw sim::FileError(odometry, "",
                           fmt::format("has no pose within {} s of the frame at {}; leave the "
                                       "frame out or add the pose",
                                       kPoseApart, times[i]));
    }
    recording.odometry.push_back(PlanarFromFile(*measured[i]));
  }
  const sim::PlanarPose back = sim::Inverse(recording.odometry.front());
  for (sim::PlanarPose& pose : recording.odometry) pose = sim::Compose(back, pose);
  const auto truth = TruthAt(times, recording.folder.truth, folder / "groundtruth.txt");
  recording.truth.resize(times.size());
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (truth[i]) recording.truth[i] = BodyFromFile(*truth[i], 0.0);
  }
  recording.tilts = TiltsOf(truth);
  return recording;
}

CameraLens DriveSource::lens() const {
  return recording_ ? recording_->folder.intrinsics : LensOf(traversal_);
}

bool DriveSource::has_truth() const {
  return !recording_ ||
         std::all_of(recording_->truth.begin(), recording_->truth.end(), [](const auto& pose) {
           return pose.has_value();
         });
}

void DriveSource::ForEach(const std::function<void(const DriveFrame&)>& take) const {
  if (!recording_) {
    Traverse(world_, changed_, traversal_, [&](const TraversalFrame& frame) {
      take({frame.step / kFramesASecond, frame.color, frame.depth, frame.ranges, frame.true_depth,
            frame.dead_reckoned, frame.true_pose});
    });
    return;
  }
  RecordingCheck check(recording_->place, recording_->folder.intrinsics);
  for (std::size_t i = 0; i < recording_->folder.frames.size(); ++i) {
    const TumFrame& frame = recording_->folder.frames[i];
    DriveFrame read;
    read.time = frame.time;
    read.color = ReadRgb(frame.color);
    check.TakeColor(frame.color, read.color);
    read.depth = ReadTumDepth(frame.depth);
    check.TakeDepth(frame.depth, read.depth);
    read.odometry = recording_->odometry[i];
    read.truth = recording_->truth[i];
    read.tilt = recording_->tilts[i];
    take(read);
  }
  check.Finish();
}

}  // namespace bulletnav::bench
