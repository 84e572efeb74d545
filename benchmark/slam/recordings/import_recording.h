// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "benchmark/slam/io/recorded_frame.h"
#include "benchmark/slam/recordings/recording_format.h"

namespace bulletnav::bench {

struct ImportRecordingSpec {
  std::filesystem::path source = {};  // a TUM folder, or a sequence of KITTI's odometry benchmark
  std::filesystem::path out = {};     // a folder that holds no recording yet
  RecordingFormat format = RecordingFormat::kTum;  // of `out`; kTum or kKitti
  /// Poses as 't x y z qx qy qz qw' lines, instead of the source's own; empty: that, or none.
  std::filesystem::path odometry = {};
  std::filesystem::path truth = {};
  std::optional<Intrinsics> intrinsics = {};  // instead of the source's
  double most_apart = 0.02;                   // seconds between the parts of a frame
};

/// What came of an import, and what its user should know.
struct ImportOutcome {
  std::string format;  // "TUM" or "KITTI"
  int frames = 0;
  int with_truth = 0;
  int left_out = 0;        // pictures without one of depth near in time
  bool is_visual = false;  // odometry was made from pictures
  int guessed = 0;         // steps of it that were not seen
};

/// Makes folders of recordings. Expects: kTum or kKitti (checked). Throws as the writers do.
std::unique_ptr<RecordingWriter> MakeRecordingWriter(RecordingFormat format,
                                                     const std::filesystem::path& folder,
                                                     const Intrinsics& intrinsics);

/// Reads every picture of a recording, checks it, and writes a folder, of which slam run takes
/// TUM's, with odometry: the source's own, or visual odometry. KITTI's stereo pictures become
/// depth. Throws sim::FileError, one line with the file and the remedy: for sources of neither
/// kind, what readers of tum.h and kitti_folder.h find (missing or unsynchronised pictures, times
/// that do not rise, unknown intrinsics), damaged pictures, pictures of different sizes, a
/// principal point outside of them, depth that is empty throughout, frames without odometry, truth
/// of which no pose is near a frame in time, and visual odometry that lost its way in more than
/// half of the steps. What was written until then has no lists and is no recording.
ImportOutcome ImportRecording(const ImportRecordingSpec& spec,
                              const std::function<void(int frames)>& advance = {});

}  // namespace bulletnav::bench
