// SPDX-License-Identifier: MIT
#include "benchmark/slam/runs/drive_play.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>

#include "benchmark/privileged/visibility.h"
#include "benchmark/slam/runs/drive_frames.h"
#include "benchmark/slam/runs/drive_traces.h"
#include "benchmark/slam/runs/frame_eye.h"
#include "benchmark/slam/runs/measure_drive.h"
#include "benchmark/slam/runs/measure_stages.h"
#include "benchmark/slam/runs/slam_weights.h"
#include "benchmark/slam/runs/travel.h"
#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

using Clock = std::chrono::steady_clock;

/// A detector at work.
struct RunningDetector {
  std::string name;
  std::unique_ptr<agent::LoopDetector> detector;
  std::vector<agent::LoopCandidate> named;
  std::vector<double> milliseconds;

  void Take(const agent::LoopFrame& frame) {
    const auto start = Clock::now();
    const std::vector<agent::LoopCandidate> found = detector->Add(frame);
    milliseconds.push_back(MillisecondsSince(start));
    named.insert(named.end(), found.begin(), found.end());
  }
};

/// A drive while it is played.
class DrivePlay {
 public:
  DrivePlay(const SlamConfig& config, const Drive& drive,
            const std::shared_ptr<const agent::Vocabulary>& vocabulary)
      : config_(config),
        source_(config, drive),
        eye_(config, source_.lens()),
        travel_(config.apart_m),
        sequences_(LoadSequences(config)),
        filter_(LoadFilter(config)) {
    played_.result.drive = drive.name;
    played_.result.scene = drive.scene;
    played_.result.actions = drive.actions;
    detectors_.reserve(config.detectors.size());
    for (const DetectorEntry& entry : config.detectors) {
      const sim::YamlNode name = sim::ParseYaml(entry.detector, "detectors");
      const auto make = agent::ConfigureLoopDetector(name, entry.parameters);
      detectors_.push_back(
          {entry.name,
           make({vocabulary, eye_.descriptor_size(), sequences_, filter_, eye_.places()}),
           {},
           {}});
    }
  }

  PlayedDrive Play() {
    source_.ForEach([this](const DriveFrame& frame) {
      Take(frame);
    });
    for (RunningDetector& running : detectors_) {
      const auto start = Clock::now();
      const auto late = running.detector->Finish();
      running.named.insert(running.named.end(), late.begin(), late.end());
      if (late.empty()) continue;
      const double each = MillisecondsSince(start) / static_cast<double>(kept_.size());
      played_.times[running.name + kAtTheEnd] = {each, each};
    }
    played_.result.frames = static_cast<int>(kept_.size());
    played_.result.travelled_m = travel_.metres();
    if (source_.has_truth()) {
      Measure();
    } else if (!truth_frames_.empty()) {
      played_.result.with_truth = static_cast<int>(truth_frames_.size());
    }
    for (const RunningDetector& running : detectors_) Close(running);
    if (truth_) CloseWithTruth();
    played_.times["corners"] = TimesOf(corners_ms_);
    if (eye_.describes()) played_.times["descriptors"] = TimesOf(descriptors_ms_);
    played_.times["verification of a pair"] = TimesOf(verify_ms_);
    return std::move(played_);
  }

 private:
  void Take(const DriveFrame& frame) {
    auto start = Clock::now();
    FrameCorners corners = eye_.Corners(frame);
    corners_ms_.push_back(MillisecondsSince(start));
    start = Clock::now();
    const FrameDescription description = eye_.Describe(frame);
    if (eye_.describes()) descriptors_ms_.push_back(MillisecondsSince(start));
    agent::LoopFrame seen;
    seen.number = static_cast<int>(kept_.size());
    seen.width_px = frame.color.width;
    seen.height_px = frame.color.height;
    seen.color = frame.color.pixels;
    seen.features = &corners.features;
    seen.descriptor = description.descriptor;
    seen.cells = description.cells;
    if (eye_.places()) seen.code = &description.code;
    seen.depth = frame.depth.metres;
    if (const auto* pinhole = std::get_if<Intrinsics>(&eye_.lens())) seen.camera = *pinhole;
    seen.odometry = frame.odometry;
    seen.comparable = travel_.Next(frame.odometry);
    for (RunningDetector& running : detectors_) running.Take(seen);
    played_.seconds.push_back(frame.time);
    played_.odometry.push_back(frame.odometry);
    if (frame.truth) {
      const DepthPicture& depth = frame.true_depth.width > 0 ? frame.true_depth : frame.depth;
      truth_frames_.push_back({*frame.truth, Coarsened(depth, eye_.lens()), seen.comparable});
      truth_frames_.back().seen.tilt = frame.tilt;
      played_.truth.push_back(*frame.truth);
    }
    kept_.push_back(std::move(corners));
  }

  void Measure() {
    std::function<bool(const sim::BodyPose&, const sim::BodyPose&)> is_node;
    if (source_.world() != nullptr) {
      is_node = [this](const sim::BodyPose& a, const sim::BodyPose& b) {
        return IsInNode(*source_.world(), config_.body, a, b);
      };
    }
    truth_.emplace(truth_frames_, is_node);
    played_.covisible = CovisibleMatrix(*truth_);
    played_.result.odometry = MeasureBoth(played_.truth, played_.odometry);
  }

  /// What becomes of the pairs that a detector took for loops.
  std::vector<LoopRecord> Verified(const RunningDetector& running) {
    std::vector<LoopRecord> records;
    for (const agent::LoopCandidate& pair : running.named) {
      if (!pair.is_proposed) continue;
      LoopRecord& record = records.emplace_back();
      record.later = pair.later;
      record.earlier = pair.earlier;
      record.score = pair.score;
      Verify(&record);
      if (!truth_) continue;
      record.is_covisible = truth_->Is(LoopKind::kCovisible, pair.later, pair.earlier);
      record.turned_deg =
          sim::RadToDeg(sim::RelativePose(played_.truth[static_cast<std::size_t>(pair.earlier)],
                                          played_.truth[static_cast<std::size_t>(pair.later)])
                            .yaw);
    }
    return records;
  }

  void Verify(LoopRecord* record) {
    const auto motion = MotionOf(record->earlier, record->later);
    if (!motion) return;
    record->inliers = motion->inliers;
    record->motion = motion->X_AB;
  }

  /// Detectors name many pairs of others: each is looked at once.
  std::optional<FrameMotion> MotionOf(int earlier, int later) {
    const auto [known, is_new] = motions_.try_emplace({earlier, later});
    if (!is_new) return known->second;
    const auto start = Clock::now();
    known->second = eye_.Motion(kept_[static_cast<std::size_t>(earlier)],
                                kept_[static_cast<std::size_t>(later)]);
    verify_ms_.push_back(MillisecondsSince(start));
    return known->second;
  }

  /// Back end and figures of a detector.
  void Close(const RunningDetector& running) {
    PlayedDetector& played = played_.detectors.emplace_back();
    played.name = running.name;
    played.loops = Verified(running);
    played.trace = running.detector->Trace();
    played.similarity = SimilarityMatrix(running.named, played_.result.frames);
    std::vector<MeasuredLoop> measured;
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < played.loops.size(); ++i) {
      const LoopRecord& loop = played.loops[i];
      if (loop.inliers == 0) continue;
      measured.push_back({loop.later, loop.earlier, loop.motion});
      places.push_back(i);
    }
    played.back_end = RunBackEnd(played_.odometry, measured, config_.back_end);
    DetectorResult& result = played_.result.detectors.emplace_back();
    result.name = running.name;
    result.outcome.proposed = static_cast<int>(played.loops.size());
    result.outcome.verified = static_cast<int>(measured.size());
    result.outcome.trouble = played.back_end.trouble;
    result.outcome.accepted = static_cast<int>(played.back_end.accepted.size());
    for (const int accepted : played.back_end.accepted) {
      LoopRecord& loop = played.loops[places[static_cast<std::size_t>(accepted)]];
      loop.is_accepted = true;
      if (!truth_) continue;
      loop.is_wrong = IsOff(measured[static_cast<std::size_t>(accepted)], played_.truth);
      if (loop.is_wrong) ++result.outcome.wrong;
    }
    if (truth_) {
      result.outcome.error = MeasureBoth(played_.truth, played.back_end.poses);
      MeasureRanking(running.named, *truth_, source_.world() != nullptr, &result);
      result.stages = StagesOf(played.trace);
    }
    played_.times[running.name] = TimesOf(running.milliseconds);
  }

  /// Of a detector with sequences, where the config names a flat comparison.
  std::optional<StageOutcome> StagesOf(const agent::SequenceTrace& trace) const {
    if (trace.sequences.empty()) return std::nullopt;
    for (const RunningDetector& running : detectors_) {
      if (running.name != config_.against) continue;
      return MeasureStages(trace, running.named, *truth_, played_.truth);
    }
    return std::nullopt;
  }

  void CloseWithTruth() {
    const std::vector<MeasuredLoop> loops = TrueLoops(truth_frames_, *truth_);
    const BackEndOutcome back_end = RunBackEnd(played_.odometry, loops, config_.back_end);
    LoopOutcome& outcome = played_.result.true_loops.emplace();
    outcome.proposed = static_cast<int>(loops.size());
    outcome.verified = outcome.proposed;
    outcome.accepted = static_cast<int>(back_end.accepted.size());
    outcome.trouble = back_end.trouble;
    outcome.error = MeasureBoth(played_.truth, back_end.poses);
  }

  const SlamConfig& config_;
  DriveSource source_;
  FrameEye eye_;
  Travel travel_;
  std::shared_ptr<const agent::SequenceModel> sequences_;
  std::shared_ptr<const agent::SequenceFilter> filter_;
  std::vector<RunningDetector> detectors_;
  std::vector<FrameCorners> kept_;                                     // until the end of the drive
  std::map<std::pair<int, int>, std::optional<FrameMotion>> motions_;  // of verified pairs
  std::vector<TruthFrame> truth_frames_;
  std::optional<LoopTruth> truth_;
  std::vector<double> corners_ms_;
  std::vector<double> descriptors_ms_;
  std::vector<double> verify_ms_;
  PlayedDrive played_;
};

}  // namespace

void CheckDrives(const SlamConfig& config, std::span<const Drive> drives) {
  CheckWeights(config);
  bool has_scene = false;
  for (const Drive& drive : drives) {
    if (drive.is_recording) {
      const FrameEye eye(config, DriveSource(config, drive).lens());
    } else if (!has_scene) {
      has_scene = true;
      const FrameEye eye(config, LensOf(TraversalOf(config, 0, 0)));
    }
  }
}

PlayedDrive PlayDrive(const SlamConfig& config, const Drive& drive,
                      std::shared_ptr<const agent::Vocabulary> vocabulary) {
  return DrivePlay(config, drive, vocabulary).Play();
}

}  // namespace bulletnav::bench
