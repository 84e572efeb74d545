// SPDX-License-Identifier: MIT
#include "benchmark/slam/io/kitti.h"

#include <fmt/core.h>

#include "benchmark/base/counted.h"
#include "benchmark/slam/io/file_frames.h"
#include "benchmark/slam/io/rigid_numbers.h"
#include "benchmark/slam/io/text_lines.h"
#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

using Matrix34 = Eigen::Matrix<double, 3, 4, Eigen::RowMajor>;

/// Where the first camera stands.
agent::SpatialPose FirstCamera() {
  return CameraInFile(sim::PlanarPose{}, 0.0);
}

agent::SpatialPose PoseOf(const TextLine& line) {
  constexpr double kRounding = 0.01;
  line.ExpectWords(12, "r11 r12 r13 x r21 r22 r23 y r31 r32 r33 z");
  const std::vector<double> numbers = line.Numbers(0, 12);
  const Matrix34 matrix = Eigen::Map<const Matrix34>(numbers.data());
  const Eigen::Matrix3d rotation = matrix.leftCols<3>();
  const Eigen::Matrix3d square = rotation * rotation.transpose();
  if ((square - Eigen::Matrix3d::Identity()).norm() > kRounding || rotation.determinant() < 0.0) {
    line.Fail("the numbers are no rotation with a position; its columns must be at right angles");
  }
  return {matrix.col(3), Eigen::Quaterniond(rotation).normalized()};
}

}  // namespace

std::vector<agent::SpatialPose> ReadKittiPoses(const std::filesystem::path& file) {
  std::vector<agent::SpatialPose> poses;
  ForEachLine(file, [&](const TextLine& line) {
    const agent::SpatialPose pose = PoseOf(line);
    ExpectNear(line, pose.position);
    poses.push_back(agent::Compose(FirstCamera(), pose));
  });
  if (poses.empty()) throw sim::FileError(file, "", "there are no poses");
  return poses;
}

std::string ToKitti(const CameraTrajectory& trajectory) {
  std::string text;
  for (const TimedPose& timed : trajectory) {
    const agent::SpatialPose seen =
        agent::Compose(agent::Inverse(trajectory.front().pose), timed.pose);
    Matrix34 matrix;
    matrix << seen.rotation.toRotationMatrix(), seen.position;
    for (int i = 0; i < 12; ++i) text += fmt::format("{}{}", i > 0 ? " " : "", matrix.data()[i]);
    text += '\n';
  }
  return text;
}

std::vector<double> ReadKittiTimes(const std::filesystem::path& file) {
  std::vector<double> times;
  ForEachLine(file, [&](const TextLine& line) {
    line.ExpectWords(1, "seconds");
    const double time = line.Number(0);
    if (!times.empty() && time <= times.back()) {
      line.Fail(
          fmt::format("time {} is not after the line before it, {}; a line is a picture, so mend "
                      "the times, or leave out those that are there twice with their pictures",
                      time, times.back()));
    }
    times.push_back(time);
  });
  return times;
}

std::string ToKittiTimes(const CameraTrajectory& trajectory) {
  std::string text;
  for (const TimedPose& timed : trajectory) text += fmt::format("{}\n", timed.time);
  return text;
}

namespace {

/// The 12 numbers of a camera's projection.
std::vector<double> ReadProjection(const std::filesystem::path& file, int camera) {
  const std::string name = fmt::format("P{}:", camera);
  std::vector<double> found;
  ForEachLine(file, [&](const TextLine& line) {
    if (line.words()[0] != name) return;
    line.ExpectWords(13, name + " and 12 numbers");
    found = line.Numbers(1, 12);
    if (!(found[0] > 0.0 && found[5] > 0.0)) line.Fail("focal lengths must be positive");
  });
  if (found.empty()) {
    throw sim::FileError(file, "",
                         "there is no line '" + name + "', so the intrinsics are unknown; add it");
  }
  return found;
}

}  // namespace

Intrinsics ReadKittiCalibration(const std::filesystem::path& file, int camera) {
  const std::vector<double> p = ReadProjection(file, camera);
  return {p[0], p[5], p[2], p[6]};
}

double ReadKittiBaseline(const std::filesystem::path& file, int left, int right) {
  const std::vector<double> p = ReadProjection(file, left);
  const std::vector<double> q = ReadProjection(file, right);
  const double baseline = p[3] / p[0] - q[3] / q[0];
  if (!(baseline > 0.0)) {
    throw sim::FileError(file, "",
                         fmt::format("by P{} and P{} the cameras are not beside each other; mend "
                                     "the fourth number of each, or add depth/",
                                     left, right));
  }
  return baseline;
}

std::string ToKittiCalibration(const Intrinsics& k) {
  std::string text;
  for (int camera = 0; camera < 4; ++camera) {
    text += fmt::format("P{}: {} 0 {} 0 0 {} {} 0 0 0 1 0\n", camera, k.fx, k.cx, k.fy, k.cy);
  }
  return text;
}

CameraTrajectory ReadKittiTrajectory(const std::filesystem::path& poses,
                                     const std::filesystem::path& times) {
  const std::vector<agent::SpatialPose> read = ReadKittiPoses(poses);
  const std::vector<double> seconds = ReadKittiTimes(times);
  if (read.size() != seconds.size()) {
    throw sim::FileError(times, "",
                         Counted(seconds.size(), "time") + " for " + Counted(read.size(), "pose") +
                             " of " + poses.string() + "; give one for each");
  }
  CameraTrajectory trajectory;
  trajectory.reserve(read.size());
  for (std::size_t i = 0; i < read.size(); ++i) trajectory.push_back({seconds[i], read[i]});
  return trajectory;
}

}  // namespace bulletnav::bench
