// SPDX-License-Identifier: MIT
#include "benchmark/evaluate_perception/perception_figures.h"

#include <map>

#include "benchmark/base/scene_names.h"

namespace bulletnav::bench {

namespace {

std::vector<std::string> NamesOf(std::span<const SceneCases> scenes) {
  std::vector<std::string> files;
  for (const SceneCases& cases : scenes) files.push_back(cases.scene.string());
  const std::map<std::string, std::string> called = SceneNames(files);
  for (std::string& file : files) file = called.at(file);
  return files;
}

}  // namespace

PerceptionFigures MeasurePerception(std::span<const SceneCases> scenes,
                                    const PerceptionConfig& config) {
  PerceptionFigures figures;
  figures.connection = MeasureConnection(scenes, config.same_node, config.seed);
  figures.explorable = MeasureExplorable(scenes, config.explorable);
  figures.relative_pose = MeasureRelativePoses(scenes, config.seed);
  figures.score = MeasureScores(scenes, config.seed);
  const std::vector<std::string> names = NamesOf(scenes);
  for (std::size_t s = 0; s < scenes.size(); ++s) {
    const auto one = scenes.subspan(s, 1);
    const RelativePoseFigures poses = MeasureRelativePoses(one, config.seed);
    figures.places += one.front().count();
    PerceptionFigures::Scene scene;
    scene.scene = names[s];
    const ConnectionFigures connection = MeasureConnection(one, config.same_node, config.seed);
    scene.connection_ap = connection.average_precision;
    scene.false_positives_3_to_5m =
        connection.by_distance.at(DistanceBin(4.0)).false_positive_rate.value;
    scene.explorable_f1 = MeasureExplorable(one, config.explorable).at.f1;
    scene.direction_near = poses.all.direction_near.value;
    scene.distance_error = poses.all.distance_error.value;
    scene.choice_within_1m = MeasureScores(one, config.seed).model.within_1m.value;
    figures.scenes.push_back(std::move(scene));
  }
  return figures;
}

}  // namespace bulletnav::bench
