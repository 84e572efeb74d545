// SPDX-License-Identifier: MIT
#include "benchmark/slam/traversal/tum_recorder.h"

#include "benchmark/slam/io/file_frames.h"

namespace bulletnav::bench {

RecordedFrame RecordOf(const TraversalFrame& frame, const TraversalSpec& spec) {
  const double height = spec.body.camera_height;
  return {frame.step / kFramesASecond, frame.color, frame.depth,
          CameraInFile(frame.true_pose, height), CameraInFile(frame.dead_reckoned, height)};
}

TumRecorder::TumRecorder(const std::filesystem::path& folder, const TraversalSpec& spec)
    : spec_(spec), writer_(folder, IntrinsicsOf(spec.camera)) {}

void TumRecorder::Add(const TraversalFrame& frame) {
  writer_.Add(RecordOf(frame, spec_));
}

void TumRecorder::Finish() {
  writer_.Finish();
}

}  // namespace bulletnav::bench
