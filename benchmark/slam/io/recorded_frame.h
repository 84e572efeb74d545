// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <optional>

#include "benchmark/slam/io/pictures.h"
#include "benchmark/slam/io/trajectory.h"

namespace bulletnav::bench {

/// A frame of a recording, ready to be written; poses X_FC of the camera, see TimedPose.
struct RecordedFrame {
  double time = 0.0;  // seconds
  sim::Image color;   // RGB
  DepthPicture depth;
  std::optional<agent::SpatialPose> truth;
  std::optional<agent::SpatialPose> odometry;  // added up, in a frame of its own
};

/// Throws sim::FileError if a folder holds a recording of either kind, TUM's rgb.txt or KITTI's
/// times.txt: writing another one, or results, there would mix or replace its files.
void ExpectNoRecording(const std::filesystem::path& folder);
/// Likewise if it holds results of anything.
void ExpectNoResults(const std::filesystem::path& folder);

/// Writes frames as a folder of some format, which is a recording once it is finished.
class RecordingWriter {
 public:
  RecordingWriter() = default;
  virtual ~RecordingWriter() = default;
  RecordingWriter(const RecordingWriter&) = delete;
  RecordingWriter& operator=(const RecordingWriter&) = delete;
  RecordingWriter(RecordingWriter&&) = delete;
  RecordingWriter& operator=(RecordingWriter&&) = delete;

  virtual void Add(const RecordedFrame& frame) = 0;
  /// Writes the lists, which make the folder a recording: one that was killed before has none.
  virtual void Finish() = 0;
  virtual int frames() const = 0;
};

}  // namespace bulletnav::bench
