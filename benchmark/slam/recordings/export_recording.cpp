// SPDX-License-Identifier: MIT
#include "benchmark/slam/recordings/export_recording.h"

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "benchmark/slam/io/file_frames.h"
#include "benchmark/slam/io/g2o.h"
#include "benchmark/slam/recordings/import_recording.h"
#include "benchmark/slam/runs/drive_files.h"
#include "benchmark/slam/runs/drive_frames.h"
#include "benchmark/slam/runs/slam_fingerprints.h"
#include "benchmark/slam/runs/slam_runner.h"
#include "sim/base/error.h"
#include "sim/base/files.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;

/// What is exported: a drive, the config that it belongs to, and its folder of results.
struct Chosen {
  SlamConfig config;
  Drive drive;
  fs::path results;  // empty: none
};

[[noreturn]] void FailWithKnown(const std::string& what, const std::vector<std::string>& known) {
  std::string text = what + "; there are:";
  for (const std::string& name : known) text += " " + name;
  throw sim::Error(text);
}

Chosen ChooseDrive(const ExportSpec& spec) {
  Chosen chosen;
  chosen.config = ReadSlamRun(spec.source);
  std::vector<std::string> names;
  std::optional<Drive> found;
  const std::vector<Drive> drives = DrivesOf(chosen.config);
  for (const Drive& drive : drives) {
    names.push_back(drive.name);
    if (drive.name == spec.drive || (spec.drive.empty() && drives.size() == 1)) found = drive;
  }
  if (!found) FailWithKnown("name one of the drives with --drive", names);
  chosen.drive = *found;
  const fs::path results = DriveFolder(spec.source, found->name);
  if (HasDrive(results)) chosen.results = results;
  return chosen;
}

Chosen Choose(const ExportSpec& spec) {
  if (fs::exists(spec.source / "config.yaml")) return ChooseDrive(spec);
  if (!fs::exists(spec.source / "rgb.txt")) {
    throw sim::FileError(spec.source, "",
                         "holds neither a recording (rgb.txt) nor results of slam run "
                         "(config.yaml); name such a folder");
  }
  if (!spec.drive.empty()) {
    throw sim::FileError(spec.source, "",
                         "is a recording and has no drives to choose from; leave --drive out");
  }
  Chosen chosen;
  const std::string name = spec.source.filename().string();
  chosen.drive = {name, spec.source, true, 0, 0, name};
  return chosen;
}

/// Drives again.
int WriteFrames(const ExportSpec& spec, const Chosen& chosen,
                const std::function<void(int)>& advance) {
  const DriveSource source(chosen.config, chosen.drive);
  const CameraLens lens = source.lens();
  if (!std::holds_alternative<Intrinsics>(lens)) {
    throw sim::FileError(spec.source, "",
                         "has drives with panoramas; recordings are of flat pictures, so export a "
                         "run whose config has no 'panorama'");
  }
  const auto writer = MakeRecordingWriter(spec.format, spec.out, std::get<Intrinsics>(lens));
  const double height = chosen.config.body.camera_height;
  source.ForEach([&](const DriveFrame& frame) {
    RecordedFrame record;
    record.time = frame.time;
    record.color = frame.color;
    record.depth = frame.depth;
    record.odometry = CameraInFile(frame.odometry, height);
    if (frame.truth) record.truth = CameraInFile(*frame.truth, height);
    writer->Add(record);
    if (advance) advance(writer->frames());
  });
  writer->Finish();
  return writer->frames();
}

/// A recording keeps what a level body's poses would lose.
int CopyFrames(const ExportSpec& spec, const Chosen& chosen,
               const std::function<void(int)>& advance) {
  ImportRecordingSpec copy;
  copy.source = chosen.drive.source;
  copy.out = spec.out;
  copy.format = spec.format;
  return ImportRecording(copy, advance).frames;
}

/// Trajectories of a drive's detectors beside its frames.
void CopyTrajectories(const Chosen& chosen, const fs::path& out) {
  if (chosen.results.empty()) return;
  for (const DetectorEntry& detector : chosen.config.detectors) {
    const fs::path file = chosen.results / (detector.name + ".tum");
    if (!fs::exists(file)) continue;
    sim::WriteFileAtomically(out / (detector.name + ".txt"), sim::ReadTextFile(file));
  }
}

/// A chain of odometry, surer by hand-set steps as the back end takes them.
agent::PlanarPoseGraph ChainOf(const Chosen& chosen) {
  std::vector<sim::PlanarPose> poses;
  const DriveSource source(chosen.config, chosen.drive);
  source.ForEach([&](const DriveFrame& frame) {
    poses.push_back(frame.odometry);
  });
  BackEndOutcome outcome = RunBackEnd(poses, {}, chosen.config.back_end);
  if (!outcome.trouble.empty()) {
    throw sim::FileError(chosen.drive.source, "", "odometry makes no graph: " + outcome.trouble);
  }
  return std::move(outcome.graph);
}

int WriteGraph(const ExportSpec& spec, const Chosen& chosen) {
  if (spec.detector.empty()) {
    const agent::PlanarPoseGraph graph = ChainOf(chosen);
    WriteG2o(spec.out, graph);
    return static_cast<int>(graph.vertices.size());
  }
  if (!chosen.results.empty() && !HasDrive(chosen.results)) {
    throw sim::FileError(chosen.results, "",
                         "is not played to its end; call 'slam run' with the same config again");
  }
  const fs::path file = chosen.results / (spec.detector + ".g2o");
  if (chosen.results.empty() || !fs::exists(file)) {
    std::vector<std::string> names;
    for (const DetectorEntry& detector : chosen.config.detectors) names.push_back(detector.name);
    FailWithKnown("there is no graph of '" + spec.detector + "' of the drive '" +
                      chosen.drive.name + "'; name a detector of results of slam run",
                  names);
  }
  const AnyPoseGraph graph = ReadG2o(file);
  WriteG2o(spec.out, graph);
  return static_cast<int>(std::visit(
      [](const auto& any) {
        return any.vertices.size();
      },
      graph));
}

}  // namespace

int ExportRecording(const ExportSpec& spec, const std::function<void(int)>& advance) {
  if (!spec.detector.empty() && spec.format != RecordingFormat::kG2o) {
    throw sim::Error("--detector chooses a pose graph, so it needs --format g2o; leave it out");
  }
  const Chosen chosen = Choose(spec);
  if (!chosen.results.empty()) CheckFingerprints(chosen.config, spec.source);
  if (fs::exists(spec.out) && fs::equivalent(spec.source, spec.out)) {
    throw sim::FileError(spec.out, "", "is what is exported; name another --out");
  }
  if (spec.format == RecordingFormat::kG2o) return WriteGraph(spec, chosen);
  const int frames = chosen.drive.is_recording ? CopyFrames(spec, chosen, advance)
                                               : WriteFrames(spec, chosen, advance);
  if (spec.format == RecordingFormat::kTum) CopyTrajectories(chosen, spec.out);
  return frames;
}

}  // namespace bulletnav::bench
