// SPDX-License-Identifier: MIT
#include "benchmark/slam/runs/slam_runner.h"

#include <memory>
#include <set>
#include <string>

#include "benchmark/base/program_version.h"
#include "benchmark/slam/io/recorded_frame.h"
#include "benchmark/slam/runs/added_detectors.h"
#include "benchmark/slam/runs/drive_files.h"
#include "benchmark/slam/runs/slam_fingerprints.h"
#include "benchmark/slam/runs/vocabulary.h"
#include "sim/base/error.h"
#include "sim/base/files.h"
#include "sim/base/folder_lock.h"
#include "sim/config/yaml_writer.h"
#include "sim/threads/worker_pool.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;

constexpr const char* kConfig = "config.yaml";

std::function<void()> Start(const SlamRunOptions& options, const std::string& what, int total) {
  if (!options.progress) return [] {};
  return options.progress(what, total);
}

/// Sees that the config goes on with the one that is there; where no drive is done it may be any.
void CheckConfig(const SlamConfig& config, const fs::path& folder, bool is_new) {
  const fs::path file = folder / kConfig;
  if (!fs::exists(file) || sim::ReadTextFile(file) == sim::ToYaml(config)) return;
  const SlamConfig before = ReadSlamRun(folder);
  if (is_new || OnlyAddsDetectors(before, config)) return;
  throw sim::FileError(file, "",
                       "is another config than this run's, which may only add detectors; choose "
                       "another --out");
}

void MakeAllHouses(const SlamConfig& config, const SlamRunOptions& options) {
  const auto start = [&](const std::string& what, int total) {
    return Start(options, what, total);
  };
  if (config.houses) MakeHouses(*config.houses, CommittedVersion(), options.workers, start);
  if (config.changed && config.changed->houses) {
    MakeHouses(*config.changed->houses, CommittedVersion(), options.workers, start);
  }
  if (config.vocabulary) {
    MakeHouses(config.vocabulary->houses, CommittedVersion(), options.workers, start);
  }
}

std::shared_ptr<const agent::Vocabulary> Vocabulary(const SlamConfig& config,
                                                    const SlamRunOptions& options) {
  if (!config.vocabulary) return nullptr;
  const auto advance = Start(options, "growing a vocabulary", 1);
  auto vocabulary = GrowVocabulary(config, options.workers);
  advance();
  return vocabulary;
}

std::set<std::string> NamesDone(const fs::path& folder) {
  std::set<std::string> names;
  const fs::path drives = folder / "drives";
  if (!fs::is_directory(drives)) return names;
  for (const fs::directory_entry& entry : fs::directory_iterator(drives)) {
    if (HasDrive(entry.path())) names.insert(entry.path().filename().string());
  }
  return names;
}

/// A result that was cut off may still be read.
void RequireWhole(const SlamConfig& config, const DriveResult& result, const fs::path& folder) {
  if (HasAllRows(config, result)) return;
  throw sim::FileError(folder, "",
                       "holds a result of other detectors than config.yaml names, or a part of "
                       "one; 'slam run' plays what lacks, or remove the folder to have the drive "
                       "played again");
}

bool IsLeft(const SlamConfig& config, const fs::path& folder) {
  return !HasDrive(folder) || !HasAllRows(config, ReadDriveResult(folder));
}

/// Plays a drive, or what its folder lacks of it.
void PlayInto(const fs::path& folder, const SlamConfig& config, const Drive& drive,
              const std::shared_ptr<const agent::Vocabulary>& vocabulary) {
  if (!HasDrive(folder)) {
    WriteDrive(folder, PlayDrive(config, drive, vocabulary));
    return;
  }
  const DriveResult earlier = ReadDriveResult(folder);
  PlayedDrive played = PlayDrive(WithMissingRows(config, earlier), drive, vocabulary);
  AddEarlierRows(config, earlier, ReadDriveTimes(folder), &played);
  WriteDrive(folder, played);
}

/// None where houses, scenes or recordings are gone.
std::vector<Drive> DrivesIfThere(const SlamConfig& config) {
  try {
    return DrivesOf(config);
  } catch (const sim::Error&) {
    return {};
  }
}

}  // namespace

fs::path DriveFolder(const fs::path& folder, const std::string& drive) {
  return folder / "drives" / drive;
}

std::vector<DriveResult> RunSlam(const SlamConfig& config, const fs::path& folder,
                                 const SlamRunOptions& options) {
  sim::MakeFolder(folder);
  const sim::FolderLock lock(folder);
  ExpectNoRecording(folder);
  const bool is_new = NamesDone(folder).empty();
  CheckConfig(config, folder, is_new);
  MakeAllHouses(config, options);
  std::vector<Drive> left;
  const std::vector<Drive> drives = DrivesOf(config);
  KeepFingerprints(config, folder, is_new);
  sim::WriteFileAtomically(folder / kConfig, sim::ToYaml(config));
  for (const Drive& drive : drives) {
    if (IsLeft(config, DriveFolder(folder, drive.name))) left.push_back(drive);
  }
  if (!left.empty()) {
    NoteVersion(folder);
    CheckDrives(config, left);
    const auto vocabulary = Vocabulary(config, options);
    const auto advance = Start(options, "drives", static_cast<int>(left.size()));
    sim::WorkerPool pool(options.workers);
    pool.ForEach(static_cast<int>(left.size()), [&](int task, int /*worker*/) {
      const Drive& drive = left[static_cast<std::size_t>(task)];
      PlayInto(DriveFolder(folder, drive.name), config, drive, vocabulary);
      advance();
    });
  }
  return ReadSlamResults(config, folder);
}

SlamConfig ReadSlamRun(const fs::path& folder) {
  const fs::path file = folder / kConfig;
  if (!fs::exists(file)) {
    throw sim::FileError(folder, "", "holds no results of 'slam run'; name a folder that it wrote");
  }
  const sim::YamlNode root = sim::ParseYaml(sim::ReadTextFile(file), file);
  if (root.yaml().IsMap() && !root.yaml()["detectors"]) {
    throw sim::FileError(file, "",
                         "names no 'detectors', so it is of another command than 'slam run'; name "
                         "a folder of results of that");
  }
  return LoadSlamConfig(file);
}

std::vector<Drive> DrivesDone(const SlamConfig& config, const fs::path& folder) {
  std::vector<Drive> done;
  std::set<std::string> left = NamesDone(folder);
  for (const Drive& drive : DrivesIfThere(config)) {
    if (left.erase(drive.name) > 0) done.push_back(drive);
  }
  for (const std::string& name : left) {
    Drive& drive = done.emplace_back();
    drive.name = name;
  }
  return done;
}

std::vector<DriveResult> ReadSlamResults(const SlamConfig& config, const fs::path& folder) {
  std::vector<DriveResult> results;
  for (const Drive& drive : DrivesDone(config, folder)) {
    results.push_back(ReadDriveResult(DriveFolder(folder, drive.name)));
    RequireWhole(config, results.back(), DriveFolder(folder, drive.name));
  }
  if (results.empty()) {
    throw sim::FileError(folder, "", "has no drive that is done; ./bulletnav slam run plays them");
  }
  return results;
}

}  // namespace bulletnav::bench
