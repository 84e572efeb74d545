// SPDX-License-Identifier: MIT
#include "benchmark/cli/train_figures.h"

#include <vector>

#include "agent/policy/exploration_view.h"
#include "benchmark/training/rl/exploration/exploration_scenes.h"
#include "benchmark/training/rl/exploration/map_simulator.h"

namespace bulletnav::bench {

void MeasureMapSimulator(const BenchScene& scene,
                         const std::function<void(const BenchFigure&)>& tell) {
  const ExplorationScenes scenes({scene.file}, scene.import, 0, 1);
  const MapSimulatorSpec spec;
  MapSimulator simulator(spec);
  std::vector<std::uint8_t> view(agent::kExplorationBytes);
  sim::Rng rng(0, "bench");
  std::uint64_t episode = 0;
  const auto begin = [&] {
    const ExplorationScenes::Drawn drawn = scenes.DrawInTurn(episode++);
    simulator.Begin(*drawn.scene, drawn.start, drawn.seed);
  };
  begin();
  const double rate = MedianRate(
      [&] {
        if (simulator.is_over()) begin();
        simulator.Show(view);
        simulator.Walk(agent::DrawAnyGoal(&rng));
      },
      spec.goal_steps);
  tell({"train_frames_map_simulator", rate, "frames/s", scene.file.filename().string(), "", 1});
}

}  // namespace bulletnav::bench
