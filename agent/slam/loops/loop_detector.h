// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "agent/models/semantic_model.h"
#include "agent/slam/features/orb.h"
#include "agent/slam/retrieval/sequence_filter.h"
#include "agent/slam/retrieval/sequence_model.h"
#include "agent/slam/retrieval/vocabulary.h"
#include "agent/slam/topology/sequences.h"
#include "agent/slam/verify/pinhole.h"
#include "sim/base/error.h"
#include "sim/math/pose.h"

namespace bulletnav::agent {

/// What a detector of loops learns of a frame: pictures, and odometry added up; no true pose.
/// Pictures and features live until Add returns.
struct LoopFrame {
  int number = 0;  // 0, 1, ...
  int width_px = 0;
  int height_px = 0;
  std::span<const std::uint8_t> color;    // [height, width, 3] RGB
  const OrbFeatures* features = nullptr;  // of `color`, shared by all who need them
  /// Of the picture as a whole, see PictureDescriber; empty where the config names none.
  std::span<const std::int16_t> descriptor;
  std::span<const std::uint8_t> cells;  // of the same network; see PictureDescriber::Cells
  const PanoramaCode* code = nullptr;   // of a panorama, by LoopContext::places; or null
  /// [height, width] metres along the camera's axis, of panoramas level; 0: none. Or empty.
  std::span<const float> depth;
  std::optional<Pinhole> camera;  // none: pictures are panoramas
  sim::PlanarPose odometry;       // from the first frame's body
  /// How many of the first frames are so far back, by travel as odometry has it, that they are
  /// asked about.
  int comparable = 0;

  /// For what works with flat pictures alone. Throws sim::Error for panoramas.
  const Pinhole& flat_camera(std::string_view who) const {
    if (camera) return *camera;
    throw sim::Error(std::string(who) +
                     " works with flat pictures; leave 'panorama' out of the config, or it");
  }
};

/// Two frames that may show the same place.
struct LoopCandidate {
  int later = 0;
  int earlier = 0;
  double score = 0.0;        // the larger, the surer; comparable within one drive
  bool is_proposed = false;  // the detector takes it for a loop, to be verified
};

/// What detectors are built with, besides their own config.
struct LoopContext {
  std::shared_ptr<const Vocabulary> vocabulary;    // of ORB
  int descriptor_size = 0;                         // of LoopFrame::descriptor; 0: there is none
  std::shared_ptr<const SequenceModel> sequences;  // of LoopFrame::cells
  std::shared_ptr<const SequenceFilter> filter;    // of LoopFrame::descriptor
  std::shared_ptr<SemanticModel> places;           // of panoramas; made LoopFrame::code
};

/// How a detector that works with sequences of frames saw the drive, for pictures.
struct SequenceTrace {
  std::vector<Sequence> sequences;          // together all frames
  std::vector<int> tried;                   // numbers of clusters
  std::vector<double> spreads;              // of each of them, see Clusters
  std::vector<std::pair<int, int>> joined;  // sequences, later and earlier, that were compared
};

/// Finds pairs of frames of a drive that show the same place. Sees what LoopFrame has and nothing
/// else. A detector D has `static constexpr std::string_view kName`, a nested struct `Config` (see
/// YamlReader) and a constructor D(const Config&, const LoopContext&), which throws Error if it
/// cannot work with the context. It is one file in agent/slam/loops/detectors/ that ends in
///   const LoopDetectorRegistration<D> registration;
/// Deterministic: what it answers is a function of config, context and frames.
class LoopDetector {
 public:
  LoopDetector() = default;
  virtual ~LoopDetector() = default;
  LoopDetector(const LoopDetector&) = delete;
  LoopDetector& operator=(const LoopDetector&) = delete;
  LoopDetector(LoopDetector&&) = delete;
  LoopDetector& operator=(LoopDetector&&) = delete;

  /// Takes the next frame. Candidates have it for their `later`, and an `earlier` below
  /// frame.comparable; at most one for each.
  virtual std::vector<LoopCandidate> Add(const LoopFrame& frame) = 0;

  /// After the last frame: candidates of detectors that need the whole drive, which are not causal.
  virtual std::vector<LoopCandidate> Finish() { return {}; }

  /// After Finish: of detectors that have sequences; else nothing.
  virtual SequenceTrace Trace() const { return {}; }
};

}  // namespace bulletnav::agent
