// SPDX-License-Identifier: MIT
#include "benchmark/evaluate_perception/perception_figures.h"

namespace bulletnav::bench {

PerceptionFigures MeasurePerception(std::span<const SceneCases> scenes,
                                    const PerceptionConfig& config) {
  PerceptionFigures figures;
  figures.connection = MeasureConnection(scenes, config.same_node, config.seed);
  figures.explorable = MeasureExplorable(scenes, config.explorable);
  figures.relative_pose = MeasureRelativePoses(scenes, config.seed);
  figures.score = MeasureScores(scenes, config.seed);
  for (std::size_t s = 0; s < scenes.size(); ++s) {
    const auto one = scenes.subspan(s, 1);
    const RelativePoseFigures poses = MeasureRelativePoses(one, config.seed);
    figures.places += one.front().count();
    PerceptionFigures::Scene scene;
    scene.scene = one.front().scene.filename().string();
    scene.connection_ap = MeasureConnection(one, config.same_node, config.seed).average_precision;
    scene.explorable_f1 = MeasureExplorable(one, config.explorable).at.f1;
    scene.direction_near = poses.all.direction_near.value;
    scene.distance_error = poses.all.distance_error.value;
    scene.choice_within_1m = MeasureScores(one, config.seed).model.within_1m.value;
    figures.scenes.push_back(std::move(scene));
  }
  return figures;
}

}  // namespace bulletnav::bench
