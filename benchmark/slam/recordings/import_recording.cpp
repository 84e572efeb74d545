// SPDX-License-Identifier: MIT
#include "benchmark/slam/recordings/import_recording.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "agent/slam/features/stereo.h"
#include "benchmark/slam/io/kitti_folder.h"
#include "benchmark/slam/io/recording_check.h"
#include "benchmark/slam/io/tum.h"
#include "benchmark/slam/io/tum_writer.h"
#include "benchmark/slam/recordings/visual_odometry.h"
#include "sim/base/check.h"
#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;

/// A frame of either kind of source.
struct SourceFrame {
  double time = 0.0;
  fs::path color;
  fs::path depth;  // or else
  fs::path right;
};

struct Source {
  std::string format;
  double depth_units = 0.0;
  Intrinsics intrinsics;
  double baseline_m = 0.0;
  std::vector<SourceFrame> frames;
  CameraTrajectory truth;
  fs::path truth_file;
  CameraTrajectory odometry;
  int left_out = 0;  // pictures
};

Source OpenTum(const ImportRecordingSpec& spec) {
  constexpr double kTumDepthUnits = 5000.0;
  TumFolder folder = ReadTumFolder(spec.source, {spec.most_apart, spec.intrinsics});
  Source source{"TUM",
                kTumDepthUnits,
                folder.intrinsics,
                0.0,
                {},
                std::move(folder.truth),
                spec.source / "groundtruth.txt",
                {}};
  for (const TumFrame& frame : folder.frames) {
    source.frames.push_back({frame.time, frame.color, frame.depth, {}});
  }
  source.left_out = folder.left_out;
  const fs::path odometry = spec.source / "odometry.txt";
  if (fs::exists(odometry)) source.odometry = ReadTumTrajectory(odometry);
  return source;
}

Source OpenKitti(const ImportRecordingSpec& spec) {
  KittiFolder folder = ReadKittiFolder(spec.source, spec.intrinsics);
  Source source{
      "KITTI", kKittiDepthUnits,        folder.intrinsics,         folder.baseline_m,
      {},      std::move(folder.truth), spec.source / "poses.txt", std::move(folder.odometry)};
  for (const KittiFrame& frame : folder.frames) {
    source.frames.push_back({frame.time, frame.color, frame.depth, frame.right});
  }
  return source;
}

Source Open(const ImportRecordingSpec& spec) {
  if (!fs::exists(spec.source)) throw sim::FileError(spec.source, "", "is not there");
  const bool is_tum = fs::exists(spec.source / "rgb.txt");
  if (!is_tum && !fs::exists(spec.source / "times.txt")) {
    throw sim::FileError(spec.source, "",
                         "is no recording: a TUM folder has rgb.txt and depth.txt, a sequence of "
                         "KITTI's has times.txt, calib.txt and image_2/");
  }
  Source source = is_tum ? OpenTum(spec) : OpenKitti(spec);
  if (!spec.odometry.empty()) source.odometry = ReadTumTrajectory(spec.odometry);
  if (!spec.truth.empty()) {
    source.truth = ReadTumTrajectory(spec.truth);
    source.truth_file = spec.truth;
  }
  return source;
}

DepthPicture DepthOf(const Source& source, const SourceFrame& frame, const sim::Image& color) {
  if (!frame.depth.empty()) {
    return ReadDepth(frame.depth, source.depth_units);
  }
  const sim::Image right = ReadRgb(frame.right);
  if (right.width != color.width || right.height != color.height) {
    throw sim::FileError(frame.right, "", "is not as large as " + frame.color.string());
  }
  agent::StereoSpec stereo;
  // What is nearer than a quarter of the picture is wide is left out, as are as many columns.
  stereo.disparities = std::clamp(color.width / 64 * 16, 16, stereo.disparities);
  if (color.width <= stereo.disparities) {
    throw sim::FileError(frame.color, "",
                         fmt::format("is of {} pixels; stereo needs more than {} columns: give "
                                     "wider pictures, or depth in depth/",
                                     SizeText(color.width, color.height), stereo.disparities));
  }
  stereo.fx = source.intrinsics.fx;
  stereo.baseline_m = source.baseline_m;
  return {color.width, color.height,
          agent::StereoDepth(color.pixels, right.pixels, color.width, color.height, stereo)};
}

std::vector<double> TimesOf(const Source& source) {
  std::vector<double> times;
  times.reserve(source.frames.size());
  for (const SourceFrame& frame : source.frames) times.push_back(frame.time);
  return times;
}

/// A recording while it is read frame by frame.
class Importer {
 public:
  explicit Importer(const ImportRecordingSpec& spec)
      : spec_(spec),
        source_(Open(spec)),
        truth_(TruthAt(TimesOf(source_), source_.truth, source_.truth_file)),
        odometry_(PosesAt(TimesOf(source_), source_.odometry, kPoseApart)),
        writer_(MakeRecordingWriter(spec.format, spec.out, source_.intrinsics)),
        visual_(source_.intrinsics),
        check_(spec.source, source_.intrinsics) {
    outcome_.format = source_.format;
    outcome_.left_out = source_.left_out;
    outcome_.is_visual = source_.odometry.empty();
  }

  ImportOutcome Run(const std::function<void(int)>& advance) {
    if (spec_.format == RecordingFormat::kKitti) {
      ExpectPosesOfAllOrNone(spec_.source, WithTruth(), truth_.size());  // before any is written
    }
    for (std::size_t i = 0; i < source_.frames.size(); ++i) {
      Take(i);
      if (advance) advance(static_cast<int>(i) + 1);
    }
    check_.Finish();
    outcome_.guessed = visual_.guessed();
    if (2 * visual_.guessed() > visual_.steps()) {
      throw sim::FileError(
          spec_.source, "",
          fmt::format("has no odometry, and in {} of {} steps too few corners of the picture "
                      "before were found to make it from pictures; give it with --odometry FILE",
                      visual_.guessed(), visual_.steps()));
    }
    writer_->Finish();
    outcome_.frames = writer_->frames();
    return outcome_;
  }

 private:
  std::size_t WithTruth() const {
    return static_cast<std::size_t>(std::count_if(truth_.begin(), truth_.end(), [](const auto& p) {
      return p.has_value();
    }));
  }

  void Take(std::size_t i) {
    const SourceFrame& from = source_.frames[i];
    RecordedFrame frame;
    frame.time = from.time;
    frame.color = ReadRgb(from.color);
    check_.TakeColor(from.color, frame.color);
    frame.depth = DepthOf(source_, from, frame.color);
    check_.TakeDepth(from.depth.empty() ? from.right : from.depth, frame.depth);
    frame.truth = truth_[i];
    if (frame.truth) ++outcome_.with_truth;
    frame.odometry = OdometryOf(i, frame);
    writer_->Add(frame);
  }

  agent::SpatialPose OdometryOf(std::size_t i, const RecordedFrame& frame) {
    if (outcome_.is_visual) return visual_.Next(frame.color, frame.depth);
    if (odometry_[i]) return *odometry_[i];
    const fs::path file = spec_.odometry.empty() ? spec_.source / "odometry.txt" : spec_.odometry;
    throw sim::FileError(file, "",
                         fmt::format("has no pose within {} s of the frame at {}; add it, or "
                                     "leave the frame out",
                                     kPoseApart, frame.time));
  }

  const ImportRecordingSpec& spec_;
  Source source_;
  std::vector<std::optional<agent::SpatialPose>> truth_;
  std::vector<std::optional<agent::SpatialPose>> odometry_;
  std::unique_ptr<RecordingWriter> writer_;
  VisualOdometry visual_;
  RecordingCheck check_;
  ImportOutcome outcome_;
};

}  // namespace

std::unique_ptr<RecordingWriter> MakeRecordingWriter(RecordingFormat format, const fs::path& folder,
                                                     const Intrinsics& intrinsics) {
  BULLETNAV_CHECK(format != RecordingFormat::kG2o);
  if (format == RecordingFormat::kKitti) return std::make_unique<KittiWriter>(folder, intrinsics);
  return std::make_unique<TumWriter>(folder, intrinsics);
}

ImportOutcome ImportRecording(const ImportRecordingSpec& spec,
                              const std::function<void(int)>& advance) {
  return Importer(spec).Run(advance);
}

}  // namespace bulletnav::bench
