// SPDX-License-Identifier: MIT
#include "benchmark/slam/runs/drive_files.h"

#include <array>
#include <charconv>
#include <cstddef>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>

#include <fmt/core.h>

#include "benchmark/slam/io/file_frames.h"
#include "benchmark/slam/io/g2o.h"
#include "benchmark/slam/io/tum.h"
#include "benchmark/slam/runs/drive_traces.h"
#include "sim/base/check.h"
#include "sim/base/error.h"
#include "sim/base/files.h"
#include "sim/config/yaml_writer.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;

constexpr const char* kResult = "result.yaml";
constexpr const char* kTimes = "times.yaml";
constexpr const char* kTruth = "groundtruth.tum";
constexpr const char* kLoopHead =
    "later,earlier,score,inliers,accepted,covisible,wrong,turned_deg,x_m,y_m,yaw_rad\n";
constexpr std::size_t kLoopColumns = 11;

/// Poses of all frames.
template <class Pose>
std::string TumOf(const PlayedDrive& drive, const std::vector<Pose>& poses) {
  BULLETNAV_CHECK_EQ(poses.size(), drive.seconds.size());
  CameraTrajectory trajectory;
  trajectory.reserve(poses.size());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    trajectory.push_back({drive.seconds[i], CameraInFile(poses[i], 0.0)});
  }
  return ToTum(trajectory);
}

std::string CsvOf(const std::vector<LoopRecord>& loops) {
  std::string text = kLoopHead;
  for (const LoopRecord& loop : loops) {
    text += fmt::format("{},{},{},{},{},{},{},{:.2f},{:.4f},{:.4f},{:.5f}\n", loop.later,
                        loop.earlier, loop.score, loop.inliers, loop.is_accepted ? 1 : 0,
                        loop.is_covisible ? 1 : 0, loop.is_wrong ? 1 : 0, loop.turned_deg,
                        loop.motion.x, loop.motion.y, loop.motion.yaw);
  }
  return text;
}

LoopRecord LoopOf(const std::array<double, kLoopColumns>& numbers) {
  LoopRecord loop;
  loop.later = static_cast<int>(numbers[0]);
  loop.earlier = static_cast<int>(numbers[1]);
  loop.score = numbers[2];
  loop.inliers = static_cast<int>(numbers[3]);
  loop.is_accepted = numbers[4] != 0.0;
  loop.is_covisible = numbers[5] != 0.0;
  loop.is_wrong = numbers[6] != 0.0;
  loop.turned_deg = numbers[7];
  loop.motion = {numbers[8], numbers[9], numbers[10]};
  return loop;
}

}  // namespace

void WriteDrive(const fs::path& folder, const PlayedDrive& drive) {
  sim::MakeFolder(folder);
  sim::RemoveLeftovers(folder);
  sim::WriteFileAtomically(folder / "odometry.tum", TumOf(drive, drive.odometry));
  if (drive.truth.size() == drive.odometry.size()) {
    sim::WriteFileAtomically(folder / kTruth, TumOf(drive, drive.truth));
  }
  for (const PlayedDetector& detector : drive.detectors) {
    sim::WriteFileAtomically(folder / (detector.name + ".tum"),
                             TumOf(drive, detector.back_end.poses));
    sim::WriteFileAtomically(folder / (detector.name + ".csv"), CsvOf(detector.loops));
    sim::WritePng(folder / (detector.name + ".similarity.png"), detector.similarity);
    WriteTrace(folder, detector.name, detector.trace);
    if (detector.back_end.trouble.empty()) {
      WriteG2o(folder / (detector.name + ".g2o"), detector.back_end.graph);
    }
  }
  if (drive.covisible.width > 0) {
    sim::WritePng(folder / "covisible.png", drive.covisible);
  }
  sim::YamlWriter times;
  times.Write(drive.times);
  sim::WriteFileAtomically(folder / kTimes, times.text());
  sim::WriteFileAtomically(folder / kResult, sim::ToYaml(drive.result));
}

bool HasDrive(const fs::path& folder) {
  return fs::exists(folder / kResult);
}

DriveResult ReadDriveResult(const fs::path& folder) {
  const fs::path file = folder / kResult;
  if (fs::file_size(file) == 0) {
    throw sim::FileError(file, "", "is empty; remove the folder to have the drive played again");
  }
  return sim::LoadYaml<DriveResult>(file);
}

TimesByStage ReadDriveTimes(const fs::path& folder) {
  if (!fs::exists(folder / kTimes)) return {};
  return sim::LoadYaml<TimesByStage>(folder / kTimes);
}

namespace {

/// Numbers with commas between; nothing if a line holds others.
std::optional<LoopRecord> ParseLoop(const std::string& line) {
  std::array<double, kLoopColumns> numbers{};
  const char* at = line.data();
  const char* end = line.data() + line.size();
  for (double& value : numbers) {
    const auto [next, error] = std::from_chars(at, end, value);
    if (error != std::errc()) return std::nullopt;
    at = next == end ? end : next + 1;
  }
  return LoopOf(numbers);
}

/// Results of a drive may have been kept without what is drawn from them.
void ExpectThere(const fs::path& file) {
  if (fs::exists(file)) return;
  throw sim::FileError(file, "",
                       "is not there any more; remove the drive's folder, and 'slam run' plays it "
                       "again");
}

}  // namespace

std::vector<sim::BodyPose> ReadTruth(const fs::path& folder) {
  std::vector<sim::BodyPose> poses;
  const fs::path file = folder / kTruth;
  if (!fs::exists(file)) return poses;
  for (const TimedPose& pose : ReadTumTrajectory(file)) {
    poses.push_back(BodyFromFile(pose.pose, 0.0));
  }
  return poses;
}

std::vector<sim::PlanarPose> ReadPoses(const fs::path& folder, const std::string& name) {
  std::vector<sim::PlanarPose> poses;
  const fs::path file = folder / (name + ".tum");
  ExpectThere(file);
  for (const TimedPose& pose : ReadTumTrajectory(file)) {
    poses.push_back(PlanarFromFile(pose.pose));
  }
  return poses;
}

std::vector<LoopRecord> ReadLoops(const fs::path& folder, const std::string& detector) {
  const fs::path file = folder / (detector + ".csv");
  ExpectThere(file);
  std::istringstream lines(sim::ReadTextFile(file));
  std::vector<LoopRecord> loops;
  std::string line;
  std::getline(lines, line);
  for (int number = 2; std::getline(lines, line); ++number) {
    const std::optional<LoopRecord> loop = ParseLoop(line);
    if (!loop) {
      throw sim::FileError(file, std::to_string(number),
                           "expected 11 numbers with commas between; play the drive again");
    }
    loops.push_back(*loop);
  }
  return loops;
}

}  // namespace bulletnav::bench
