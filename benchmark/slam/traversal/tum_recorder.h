// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>

#include "benchmark/slam/io/tum_writer.h"
#include "benchmark/slam/traversal/traversal.h"

namespace bulletnav::bench {

/// A frame of a traversal as a recording has it: a frame a tenth of a second, odometry in a frame
/// of its own whose x is ahead of where the body began.
RecordedFrame RecordOf(const TraversalFrame& frame, const TraversalSpec& spec);

/// Writes a traversal as a TUM folder, see TumWriter.
class TumRecorder {
 public:
  /// Throws sim::FileError if the folder holds a recording already.
  TumRecorder(const std::filesystem::path& folder, const TraversalSpec& spec);

  void Add(const TraversalFrame& frame);
  /// Writes the lists, which make the folder a recording: one that was killed before has none.
  void Finish();

 private:
  TraversalSpec spec_;
  TumWriter writer_;
};

}  // namespace bulletnav::bench
