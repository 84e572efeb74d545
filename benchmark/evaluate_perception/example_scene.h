// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <optional>
#include <string>

#include "benchmark/evaluate_perception/perception_cases.h"
#include "benchmark/report/scene_map.h"
#include "benchmark/training/supervised/scene_panoramas.h"
#include "sim/image/image.h"

namespace bulletnav::bench {

/// A scene made ready to show places of it. Its panoramas are finer than what models see, 256 x
/// 1024, cylindrical, and turned by half a direction, so that each direction is a twelfth of their
/// width: the one behind is the first, then clockwise.
class ExampleScene {
 public:
  /// `cases` must outlive it. Throws sim::FileError.
  ExampleScene(const SceneCases& cases, const DataConfig& config);

  const SceneCases& cases() const { return cases_; }
  const SceneMap& map() const { return map_; }
  sim::Image Panorama(int place);
  /// "living room" where the scene has a plan and the place is in a room; else empty.
  std::string RoomOf(int place) const;

 private:
  ExampleScene(const SceneCases& cases, const DataConfig& finer, const sim::ImportedScene& scene);

  const SceneCases& cases_;
  sim::PanoramaSpec size_;
  std::unique_ptr<const sim::RenderScene> render_;
  ScenePanoramas panoramas_;
  SceneMap map_;
};

}  // namespace bulletnav::bench
