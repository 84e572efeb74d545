// SPDX-License-Identifier: MIT
#include "benchmark/slam/io/tum.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "benchmark/slam/io/rigid_numbers.h"
#include "benchmark/slam/io/text_lines.h"
#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;

constexpr double kUnitsPerMetre = 5000.0;

/// Throws if a time is not later than the one before it.
template <class Timed>
void CheckRising(const std::vector<Timed>& before, double time, const TextLine& line) {
  if (before.empty() || time > before.back().time) return;
  line.Fail(
      fmt::format("time {} is not after the line before it, {}; sort the lines, leave out "
                  "what is there twice",
                  time, before.back().time));
}

template <class Timed>
std::vector<double> TimesOf(const std::vector<Timed>& all) {
  std::vector<double> times;
  times.reserve(all.size());
  for (const Timed& one : all) times.push_back(one.time);
  return times;
}

Intrinsics ReadCalibration(const fs::path& file) {
  if (!fs::exists(file)) {
    throw sim::FileError(file, "",
                         "is not there, so the intrinsics are unknown; write one line 'fx fy cx "
                         "cy', in pixels");
  }
  std::vector<Intrinsics> found;
  ForEachLine(file, [&](const TextLine& line) {
    line.ExpectWords(4, "fx fy cx cy");
    const std::vector<double> n = line.Numbers(0, 4);
    if (!(n[0] > 0.0 && n[1] > 0.0)) line.Fail("fx and fy must be positive");
    found.push_back({n[0], n[1], n[2], n[3]});
  });
  if (found.size() != 1) throw sim::FileError(file, "", "expected one line, 'fx fy cx cy'");
  return found[0];
}

}  // namespace

CameraTrajectory ReadTumTrajectory(const fs::path& file) {
  CameraTrajectory trajectory;
  ForEachLine(file, [&](const TextLine& line) {
    line.ExpectWords(8, "t x y z qx qy qz qw");
    const double time = line.Number(0);
    CheckRising(trajectory, time, line);
    trajectory.push_back({time, QuaternionPose(line, 1)});
    ExpectNear(line, trajectory.back().pose.position);
  });
  if (trajectory.empty()) throw sim::FileError(file, "", "there are no poses");
  return trajectory;
}

std::string ToTum(const CameraTrajectory& trajectory) {
  std::string text = "# t x y z qx qy qz qw\n";
  for (const TimedPose& timed : trajectory) {
    text += fmt::format("{} {}\n", timed.time, ToText(timed.pose));
  }
  return text;
}

std::vector<TimedFile> ReadTumList(const fs::path& list) {
  std::vector<TimedFile> files;
  ForEachLine(list, [&](const TextLine& line) {
    line.ExpectWords(2, "t file");
    const double time = line.Number(0);
    CheckRising(files, time, line);
    const fs::path file = list.parent_path() / line.words()[1];
    if (!fs::exists(file)) line.Fail(file.string() + " is not there; leave the line out");
    files.push_back({time, file, line.number()});
  });
  if (files.empty()) throw sim::FileError(list, "", "names no pictures; record some");
  return files;
}

std::vector<std::pair<int, int>> NearestTimes(std::span<const double> first,
                                              std::span<const double> second, double most) {
  struct Candidate {
    double apart;
    int a;
    int b;
  };
  std::vector<Candidate> candidates;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    while (begin < second.size() && second[begin] < first[i] - most) ++begin;
    for (std::size_t j = begin; j < second.size() && second[j] <= first[i] + most; ++j) {
      candidates.push_back(
          {std::abs(first[i] - second[j]), static_cast<int>(i), static_cast<int>(j)});
    }
  }
  std::stable_sort(candidates.begin(), candidates.end(), [](const auto& x, const auto& y) {
    return x.apart < y.apart;
  });
  std::vector<bool> first_taken(first.size(), false);
  std::vector<bool> second_taken(second.size(), false);
  std::vector<std::pair<int, int>> pairs;
  for (const Candidate& c : candidates) {
    const auto a = static_cast<std::size_t>(c.a);
    const auto b = static_cast<std::size_t>(c.b);
    if (first_taken[a] || second_taken[b]) continue;
    first_taken[a] = true;
    second_taken[b] = true;
    pairs.emplace_back(c.a, c.b);
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

std::vector<std::optional<agent::SpatialPose>> PosesAt(std::span<const double> times,
                                                       const CameraTrajectory& trajectory,
                                                       double most) {
  std::vector<double> known;
  known.reserve(trajectory.size());
  for (const TimedPose& pose : trajectory) known.push_back(pose.time);
  std::vector<std::optional<agent::SpatialPose>> poses(times.size());
  for (const auto& [frame, pose] : NearestTimes(times, known, most)) {
    poses[static_cast<std::size_t>(frame)] = trajectory[static_cast<std::size_t>(pose)].pose;
  }
  return poses;
}

std::vector<std::optional<agent::SpatialPose>> TruthAt(std::span<const double> times,
                                                       const CameraTrajectory& truth,
                                                       const fs::path& file) {
  auto poses = PosesAt(times, truth, kPoseApart);
  const bool fits = std::any_of(poses.begin(), poses.end(), [](const auto& pose) {
    return pose.has_value();
  });
  if (truth.empty() || times.empty() || fits) return poses;
  throw sim::FileError(
      file, "",
      fmt::format("no pose is within {} s of a frame: poses are from {} to {}, frames from {} to "
                  "{}; bring them to one clock, or leave the file out",
                  kPoseApart, truth.front().time, truth.back().time, times.front(), times.back()));
}

TumFolder ReadTumFolder(const fs::path& folder, const TumOptions& options) {
  TumFolder read;
  read.intrinsics =
      options.intrinsics ? *options.intrinsics : ReadCalibration(folder / "calibration.txt");
  const std::vector<TimedFile> colors = ReadTumList(folder / "rgb.txt");
  if (colors.size() < 2) {
    throw sim::FileError(folder / "rgb.txt", "", "names one picture; a drive needs more than one");
  }
  const std::vector<TimedFile> depths = ReadTumList(folder / "depth.txt");
  for (const auto& [color, depth] :
       NearestTimes(TimesOf(colors), TimesOf(depths), options.most_apart)) {
    const TimedFile& picture = colors[static_cast<std::size_t>(color)];
    read.frames.push_back(
        {picture.time, picture.file, depths[static_cast<std::size_t>(depth)].file});
  }
  if (2 * read.frames.size() < colors.size()) {
    throw sim::FileError(
        folder / "rgb.txt", "",
        fmt::format("only {} of {} pictures have one of depth.txt within {} s: the recordings are "
                    "not synchronised; mend their times, or let 'slam import' allow more with "
                    "--most-apart",
                    read.frames.size(), colors.size(), options.most_apart));
  }
  read.left_out = static_cast<int>(colors.size() - read.frames.size());
  const fs::path truth = folder / "groundtruth.txt";
  if (fs::exists(truth)) read.truth = ReadTumTrajectory(truth);
  return read;
}

DepthPicture ReadTumDepth(const fs::path& file) {
  return ReadDepth(file, kUnitsPerMetre);
}

void WriteTumDepth(const fs::path& file, const DepthPicture& picture) {
  WriteDepth(file, picture, kUnitsPerMetre);
}

}  // namespace bulletnav::bench
