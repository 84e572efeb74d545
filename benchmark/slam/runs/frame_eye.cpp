// SPDX-License-Identifier: MIT
#include "benchmark/slam/runs/frame_eye.h"

#include <filesystem>

#include "agent/models/model_registry.h"
#include "agent/slam/verify/verify_loop.h"
#include "agent/slam/verify/verify_panorama.h"
#include "benchmark/base/shipped_file.h"
#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

using agent::PanoramaLens;

/// Throws sim::FileError.
std::shared_ptr<agent::SemanticModel> LoadPlaces(const std::filesystem::path& file,
                                                 const SlamConfig& config) {
  agent::Rig rig;
  rig.panorama = *config.panorama;
  rig.camera_height = config.body.camera_height;
  auto model = std::dynamic_pointer_cast<agent::SemanticModel>(agent::LoadModel(file, rig));
  if (!model) throw sim::FileError(file, "", "are not the weights of a semantic model");
  return model;
}

agent::Panorama PanoramaOf(const DriveFrame& frame) {
  return {frame.color.pixels, frame.ranges};
}

}  // namespace

agent::OrbFeatures CornersOf(const sim::Image& color, const CameraLens& lens,
                             const agent::OrbSpec& spec) {
  const bool is_panorama = std::holds_alternative<PanoramaLens>(lens);
  return (is_panorama ? agent::FindOrbAround : agent::FindOrb)(color.pixels, color.width,
                                                               color.height, spec);
}

FrameEye::FrameEye(const SlamConfig& config, const CameraLens& lens)
    : lens_(lens), orb_(config.orb), verify_(config.verify), keeps_cells_(config.sequences) {
  const bool is_panorama = std::holds_alternative<PanoramaLens>(lens);
  if (config.descriptors && is_panorama) {
    panorama_describer_ = agent::LoadPanoramaDescriber(ShippedOr(*config.descriptors));
  } else if (config.descriptors) {
    describer_ = agent::LoadPictureDescriber(ShippedOr(*config.descriptors));
  }
  if (config.places && is_panorama) places_ = LoadPlaces(ShippedOr(*config.places), config);
}

int FrameEye::descriptor_size() const {
  if (panorama_describer_) return panorama_describer_->size();
  return describer_ ? describer_->config().size : 0;
}

FrameCorners FrameEye::Corners(const DriveFrame& frame) const {
  FrameCorners corners;
  corners.features = CornersOf(frame.color, lens_, orb_);
  const agent::OrbFeatures& features = corners.features;
  const DepthPicture& depth = frame.depth;
  if (const auto* panorama = std::get_if<PanoramaLens>(&lens_)) {
    corners.points = agent::PointsAt(depth.metres, depth.width, depth.height, *panorama, features);
  } else {
    corners.depths_m = agent::DepthsAt(depth.metres, depth.width, depth.height, features);
  }
  return corners;
}

FrameDescription FrameEye::Describe(const DriveFrame& frame) const {
  FrameDescription description;
  const sim::Image& color = frame.color;
  if (describer_) {
    description.descriptor = describer_->Describe(color.pixels, color.width, color.height);
    if (keeps_cells_) description.cells = describer_->Cells();
  }
  const agent::Panorama panorama = PanoramaOf(frame);
  if (panorama_describer_) description.descriptor = panorama_describer_->Describe(panorama);
  if (places_) description.code = places_->Encode({&panorama, 1}).front();
  return description;
}

std::optional<FrameMotion> FrameEye::Motion(const FrameCorners& earlier,
                                            const FrameCorners& later) const {
  if (const auto* panorama = std::get_if<PanoramaLens>(&lens_)) {
    const auto motion = agent::FindMotion({&earlier.features, earlier.points},
                                          {&later.features, later.points}, *panorama, verify_);
    if (!motion) return std::nullopt;
    return FrameMotion{motion->X_AB, motion->inliers};
  }
  const auto motion =
      agent::FindMotion({&earlier.features, earlier.depths_m}, {&later.features, later.depths_m},
                        std::get<Intrinsics>(lens_), verify_);
  if (!motion) return std::nullopt;
  const auto level = agent::LevelMotion(motion->X_AB, verify_);
  if (!level) return std::nullopt;
  return FrameMotion{*level, motion->inliers};
}

}  // namespace bulletnav::bench
