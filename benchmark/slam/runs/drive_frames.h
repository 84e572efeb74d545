// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <memory>
#include <optional>

#include "benchmark/slam/io/tum.h"
#include "benchmark/slam/runs/slam_config.h"
#include "benchmark/slam/truth/camera_lens.h"
#include "benchmark/slam/truth/covisibility.h"
#include "sim/image/image.h"
#include "sim/world.h"

namespace bulletnav::bench {

/// A frame of a drive, from the simulator or from files.
struct DriveFrame {
  double time = 0.0;                    // seconds
  sim::Image color;                     // RGB
  DepthPicture depth;                   // along the camera's axis; of panoramas level
  std::vector<float> ranges;            // of panoramas: along the rays
  DepthPicture true_depth;              // of scenes seen with noise; for measuring only
  sim::PlanarPose odometry;             // added up, from the first frame's body
  std::optional<sim::BodyPose> truth;   // where it is known; for measuring only
  std::optional<CameraTilt> tilt = {};  // with it: of a recording whose camera is not always level
};

/// The frames of a drive, one after the other.
class DriveSource {
 public:
  /// Loads the scene, or the lists of a recording. Throws sim::FileError, also for a recording
  /// without odometry.txt, whose odometry lacks the time of a frame, or whose truth has none of
  /// any.
  DriveSource(const SlamConfig& config, const Drive& drive);

  CameraLens lens() const;
  /// Null for a recording.
  const sim::World* world() const { return world_.get(); }
  bool has_truth() const;

  /// Throws sim::FileError for pictures of a recording as import does, see RecordingCheck.
  void ForEach(const std::function<void(const DriveFrame&)>& take) const;

 private:
  struct Recording {
    std::filesystem::path place;
    TumFolder folder;
    std::vector<sim::PlanarPose> odometry;            // by frame
    std::vector<std::optional<sim::BodyPose>> truth;  // by frame
    std::vector<std::optional<CameraTilt>> tilts;     // by frame
  };
  static Recording Read(const std::filesystem::path& folder);

  std::shared_ptr<const sim::World> world_;
  ChangedScene changed_;
  TraversalSpec traversal_;
  std::optional<Recording> recording_;
};

/// The drive of a config through a scene.
TraversalSpec TraversalOf(const SlamConfig& config, int actions, std::uint64_t seed);
CameraLens LensOf(const TraversalSpec& traversal);
/// Of a scene that is driven through: the same pictures with and without a GPU.
sim::WorldOptions WorldOptionsOf(const ImportSpec& import);

}  // namespace bulletnav::bench
