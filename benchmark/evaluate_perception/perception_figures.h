// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "benchmark/evaluate_perception/connection_figures.h"
#include "benchmark/evaluate_perception/explorable_figures.h"
#include "benchmark/evaluate_perception/perception_config.h"
#include "benchmark/evaluate_perception/relative_pose_figures.h"
#include "benchmark/evaluate_perception/score_figures.h"

namespace bulletnav::bench {

/// The figures of each function of Neural Topological SLAM, section 4, over all scenes.
struct PerceptionFigures {
  /// One scene's own, in short; called as SceneNames has it.
  struct Scene {
    std::string scene;
    double connection_ap = 0.0;
    double false_positives_3_to_5m = 0.0;  // of connections; see ConnectionBin
    double explorable_f1 = 0.0;
    double direction_near = 0.0;
    double distance_error = 0.0;  // metres
    double choice_within_1m = 0.0;

    template <class V>
    void Visit(V& v) {
      v("scene", scene);
      v("connection_average_precision", connection_ap);
      v("connection_false_positives_3_to_5m", false_positives_3_to_5m);
      v("explorable_f1", explorable_f1);
      v("direction_within_one", direction_near);
      v("distance_error_m", distance_error);
      v("choice_within_1m", choice_within_1m);
    }
  };
  int places = 0;
  ConnectionFigures connection;
  ExplorableFigures explorable;
  RelativePoseFigures relative_pose;
  ScoreFigures score;
  std::vector<Scene> scenes;

  template <class V>
  void Visit(V& v) {
    v("places", places);
    v("connection", connection);
    v("explorable", explorable);
    v("relative_pose", relative_pose);
    v("score", score);
    v("scenes", scenes);
  }
};

/// A function of the cases and of the config's thresholds and seed.
PerceptionFigures MeasurePerception(std::span<const SceneCases> scenes,
                                    const PerceptionConfig& config);

}  // namespace bulletnav::bench
