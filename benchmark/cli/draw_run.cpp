// SPDX-License-Identifier: MIT
#include "benchmark/cli/draw_run.h"

#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include <fmt/core.h>
#include <fmt/format.h>

#include "benchmark/base/counted.h"
#include "benchmark/cli/progress.h"
#include "benchmark/play/belief_reader.h"
#include "benchmark/report/agent_title.h"
#include "benchmark/report/animation.h"
#include "benchmark/report/filmstrip.h"
#include "benchmark/report/result_charts.h"
#include "benchmark/report/run_scene.h"
#include "benchmark/report/trajectory_plot.h"
#include "benchmark/runs/result_store.h"
#include "benchmark/runs/runner.h"
#include "sim/base/error.h"
#include "sim/base/files.h"
#include "sim/image/image.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;

constexpr double kFloorStep = 0.1;  // metres
constexpr float kQuality = 70.0F;   // of moving pictures

/// "nts, random".
std::string AgentsOf(const std::vector<EpisodeResult>& results) {
  std::set<std::string> names;
  for (const EpisodeResult& one : results) names.insert(one.key.agent);
  return fmt::format("{}", fmt::join(names, ", "));
}

/// Empty if the run has kept no trajectories and none are asked for.
std::vector<EpisodeResult> ChooseFrom(const DrawOptions& options) {
  const fs::path folder = options.run / "trajectories";
  std::vector<EpisodeResult> all = ResultsWithTrajectory(options.run);
  if (all.empty()) {
    const bool only_charts = !options.belief && !options.film && !options.animate;
    if (options.choice.is_default() && only_charts) return all;
    throw sim::FileError(folder, "",
                         "holds no trajectories, so there are no episodes to draw; run with "
                         "'trajectories: true', or leave out the options for episodes to have "
                         "the charts alone");
  }
  const std::string agents = AgentsOf(all);
  std::vector<EpisodeResult> chosen = Choose(std::move(all), options.choice);
  if (!chosen.empty()) return chosen;
  const PlotChoice& wanted = options.choice;
  throw sim::FileError(
      folder, "",
      fmt::format("has no trajectory{}{}; its agents are {}",
                  wanted.episode.empty() ? "" : " of episode '" + wanted.episode + "'",
                  wanted.agent.empty() ? "" : " of agent '" + wanted.agent + "'", agents));
}

/// Draws episodes of one run.
class Drawer {
 public:
  explicit Drawer(const DrawOptions& options)
      : options_(options),
        out_(PlotFolder(options)),
        config_(LoadSavedRunConfig(options.run / "config.yaml")),
        agents_(AgentRowsOf(config_)) {}

  void Episodes(const std::vector<EpisodeResult>& chosen) {
    std::map<fs::path, std::vector<EpisodeTrajectory>> by_scene;
    for (const EpisodeResult& one : chosen) {
      EpisodeTrajectory trajectory = ReadTrajectory(TrajectoryPath(options_.run, one.key));
      by_scene[trajectory.scene_file].push_back(std::move(trajectory));
    }
    for (const auto& [scene, ones] : by_scene) RequireOfRun(scene, ones.front().result.key.scene);
    Progress progress("plots", static_cast<int>(chosen.size()));
    for (const auto& [scene, ones] : by_scene) Scene(scene, ones, &progress);
  }

  /// Returns how many there are.
  std::size_t Charts() const {
    const std::vector<EpisodeResult> results = ReadResults(options_.run);
    const auto goals = GoalCountCharts(Summarize(results, agents_), agents_);
    const auto distances = DistanceCharts(results, agents_);
    if (!goals.empty()) WriteFigure(ChartFigure(goals), out_ / "by_goals");
    if (!distances.empty()) WriteFigure(ChartFigure(distances), out_ / "by_distance");
    return (goals.empty() ? 0u : 1u) + (distances.empty() ? 0u : 1u);
  }

 private:
  void RequireOfRun(const fs::path& scene, const std::string& name) const {
    if (config_.fingerprints) RequireSceneOfRun(scene, name, config_.fingerprints->scenes);
  }

  void Scene(const fs::path& scene, const std::vector<EpisodeTrajectory>& chosen,
             Progress* progress) const {
    const sim::WorldOptions as_run = config_.world_options();
    const sim::ImportedScene imported = sim::ImportScene(scene, as_run.import);
    const auto world =
        std::make_shared<const sim::World>(scene.filename().string(), imported, as_run);
    const auto plan = PlanOrWarning(scene, config_.import.scale, imported.doors);
    // By height of the start in steps of rugs and thresholds, so that a plan does not depend on
    // what else is drawn.
    std::map<long, SceneMap> storeys;
    for (const EpisodeTrajectory& trajectory : chosen) {
      const long step = std::lround(trajectory.start.position.y() / kFloorStep);
      TopDownSpec spec;
      spec.floor_y = static_cast<float>(kFloorStep * static_cast<double>(step));
      const auto [storey, is_new] = storeys.try_emplace(step);
      if (is_new) storey->second = MakeSceneMap(imported.mesh, world->navmesh(), plan, spec);
      Episode(world, storey->second, trajectory);
      progress->Advance();
    }
  }

  void Episode(const std::shared_ptr<const sim::World>& world, const SceneMap& map,
               const EpisodeTrajectory& trajectory) const {
    const ResultKey& key = trajectory.result.key;
    const fs::path stem =
        out_ / fs::relative(TrajectoryPath(options_.run, key), options_.run / "trajectories")
                   .replace_extension();
    TrajectoryPlotSpec plot;
    plot.belief = options_.belief;
    plot.title = AgentTitle(key.agent, agents_);
    WriteFigure(TrajectoryPlot(map, trajectory, plot), stem);
    if (options_.film) {
      FilmstripSpec film;
      film.title = plot.title;
      film.belief = options_.belief;
      sim::WritePng(fs::path(stem) += "_film.png",
                    ToImage(Filmstrip(world, map, trajectory, film)));
    }
    if (options_.animate) Animate(world, map, trajectory, plot.title, fs::path(stem) += ".webp");
  }

  void Animate(const std::shared_ptr<const sim::World>& world, const SceneMap& map,
               const EpisodeTrajectory& trajectory, const std::string& title,
               const fs::path& file) const {
    AnimationSpec spec;
    spec.title = title;
    const fs::path beliefs = BeliefPath(options_.run, trajectory.result.key);
    if (options_.belief && fs::exists(beliefs)) {
      const auto reader = std::make_shared<BeliefReader>(beliefs);
      spec.belief = [reader](std::size_t action) {
        return action < reader->size() ? reader->At(action) : agent::Belief();
      };
    }
    sim::WriteFileAtomically(
        file, ToAnimatedWebp(EpisodeAnimation(world, map, trajectory, spec), kQuality));
  }

  DrawOptions options_;
  fs::path out_;
  RunConfig config_;
  std::vector<AgentRow> agents_;
};

}  // namespace

std::string ToText(const DrawnCount& drawn) {
  return Counted(drawn.episodes, "episode") + " and " + Counted(drawn.charts, "chart");
}

fs::path PlotFolder(const DrawOptions& options) {
  return options.out.empty() ? options.run / "plots" : options.out;
}

DrawnCount DrawRun(const DrawOptions& options) {
  Drawer drawer(options);
  const std::vector<EpisodeResult> chosen = ChooseFrom(options);
  if (!chosen.empty()) drawer.Episodes(chosen);
  return {chosen.size(), drawer.Charts()};
}

}  // namespace bulletnav::bench
