// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <functional>
#include <string>

#include "benchmark/slam/recordings/recording_format.h"

namespace bulletnav::bench {

struct ExportSpec {
  std::filesystem::path source = {};  // a recording (TUM folder), or the results of slam run
  std::filesystem::path out = {};     // a folder without a recording; of g2o: a file
  RecordingFormat format = RecordingFormat::kTum;
  std::string drive = {};     // of results; the only one if empty
  std::string detector = {};  // of g2o: whose graph; odometry's alone if empty
};

/// Writes a recording, or a drive of results, which is driven again, as another format; how many
/// frames. Of results a TUM folder has each detector's trajectory too, as DETECTOR.txt.
/// Throws sim::FileError for sources of neither kind and for an `out` that is the source or holds a
/// recording, sim::Error for drives and detectors that are not there, naming those that are.
int ExportRecording(const ExportSpec& spec, const std::function<void(int frames)>& advance = {});

}  // namespace bulletnav::bench
