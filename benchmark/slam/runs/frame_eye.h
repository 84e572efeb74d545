// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "agent/models/semantic_model.h"
#include "agent/slam/descriptors/panorama_describer.h"
#include "agent/slam/descriptors/picture_describer.h"
#include "agent/slam/features/orb.h"
#include "benchmark/slam/runs/drive_frames.h"
#include "benchmark/slam/runs/slam_config.h"
#include "benchmark/slam/truth/camera_lens.h"

namespace bulletnav::bench {

/// Corners of a frame and where they are, for verification.
struct FrameCorners {
  agent::OrbFeatures features;
  std::vector<float> depths_m;          // of flat pictures: along the camera's axis
  std::vector<Eigen::Vector3d> points;  // of panoramas: seen from the body
};

/// What a frame as a whole is like; each empty where the config names no weights for it.
struct FrameDescription {
  agent::PictureDescriptor descriptor;
  std::vector<std::uint8_t> cells;  // see LoopFrame
  agent::PanoramaCode code;
};

struct FrameMotion {
  sim::PlanarPose X_AB;
  int inliers = 0;
};

/// Corners of a picture, around if it is a panorama.
agent::OrbFeatures CornersOf(const sim::Image& color, const CameraLens& lens,
                             const agent::OrbSpec& spec);

/// What a drive's frames are turned into before detectors see them, and how two of them are
/// verified: for flat pictures and for panoramas. For one thread.
class FrameEye {
 public:
  /// Throws sim::FileError for weights that are not there or are of the other kind of pictures.
  FrameEye(const SlamConfig& config, const CameraLens& lens);

  const CameraLens& lens() const { return lens_; }
  int descriptor_size() const;
  bool describes() const { return describer_ || panorama_describer_ || places_; }
  const std::shared_ptr<agent::SemanticModel>& places() const { return places_; }  // or null

  FrameCorners Corners(const DriveFrame& frame) const;
  FrameDescription Describe(const DriveFrame& frame) const;
  /// How the body stood in the later frame, seen from the earlier one; nothing if the corners do
  /// not say.
  std::optional<FrameMotion> Motion(const FrameCorners& earlier, const FrameCorners& later) const;

 private:
  CameraLens lens_;
  agent::OrbSpec orb_;
  agent::VerifySpec verify_;
  bool keeps_cells_;
  std::unique_ptr<agent::PictureDescriber> describer_;            // of flat pictures, or null
  std::unique_ptr<agent::PanoramaDescriber> panorama_describer_;  // of panoramas, or null
  std::shared_ptr<agent::SemanticModel> places_;
};

}  // namespace bulletnav::bench
