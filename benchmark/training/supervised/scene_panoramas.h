// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>

#include "benchmark/episodes/drawn_grey.h"
#include "benchmark/training/supervised/data_config.h"
#include "sim/math/pose.h"
#include "sim/render/renderer.h"

namespace bulletnav::bench {

/// What draws a config's panoramas of a scene, in the look that it has there, ready to be shared by
/// threads. Always Embree: the same pictures on every machine. Throws sim::FileError if the file is
/// no scene. `warn`: see DrawnGrey.
std::unique_ptr<const sim::RenderScene> LoadForPanoramas(const std::filesystem::path& scene,
                                                         const DataConfig& config,
                                                         const Warn& warn = {});

/// Draws panoramas from places of one scene into the caller's memory; one per thread.
class ScenePanoramas {
 public:
  /// The scene must outlive it.
  ScenePanoramas(const sim::RenderScene& scene, const DataConfig& config);

  /// For each of `samples`, an index into `poses`: color u8 [n, rows, cols, 3], depth f32
  /// [n, rows, cols]; see sim::Renderer. An empty span: not wanted.
  /// Expects: indices within the poses, span sizes that fit (checked).
  void Render(std::span<const sim::BodyPose> poses, std::span<const int> samples,
              std::span<std::uint8_t> color, std::span<float> depth);

 private:
  std::unique_ptr<sim::Renderer> renderer_;
  double camera_height_;
};

}  // namespace bulletnav::bench
