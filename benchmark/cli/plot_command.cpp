// SPDX-License-Identifier: MIT
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/core.h>

#include "benchmark/cli/commands.h"
#include "benchmark/cli/progress.h"
#include "benchmark/evaluation/result_store.h"
#include "benchmark/evaluation/runner.h"
#include "benchmark/report/agent_title.h"
#include "benchmark/report/filmstrip.h"
#include "benchmark/report/plot_choice.h"
#include "benchmark/report/result_charts.h"
#include "benchmark/report/run_scene.h"
#include "benchmark/report/trajectory_plot.h"
#include "sim/base/error.h"
#include "sim/house/house_json.h"
#include "sim/image/image.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;

struct PlotOptions {
  fs::path run;
  fs::path out;
  PlotChoice choice;
  bool belief = false;
  bool film = false;

  /// Whether pictures of episodes are asked for by name, number or kind.
  bool wants_episodes() const { return !choice.is_default() || belief || film; }
};

/// Empty if the run has kept no trajectories and none are asked for.
std::vector<ChosenTrajectory> ChooseFrom(const PlotOptions& options) {
  const fs::path folder = options.run / "trajectories";
  std::vector<ChosenTrajectory> all = ReadTrajectories(options.run);
  if (all.empty()) {
    if (!options.wants_episodes()) return all;
    throw sim::FileError(folder, "",
                         "holds no trajectories, so there are no episodes to draw; run with "
                         "'trajectories: true', or leave out the options for episodes to have "
                         "the charts alone");
  }
  std::vector<ChosenTrajectory> chosen = Choose(std::move(all), options.choice);
  if (!chosen.empty()) return chosen;
  throw sim::Error(folder.string() + ": has no trajectory of that episode and agent");
}

std::optional<sim::FloorPlan> PlanOf(const fs::path& scene, double scale) {
  const fs::path description = fs::path(scene).replace_extension(".json");
  std::error_code unreadable;
  if (scale != 1.0 || !fs::exists(description, unreadable)) return std::nullopt;
  try {
    return sim::ReadHouseJson(description).plan;
  } catch (const sim::Error& e) {
    fmt::print(stderr, "bulletnav: warning: drawn without the house's plan: {}\n", e.what());
    return std::nullopt;
  }
}

/// Draws the trajectories of one scene.
void DrawScene(const PlotOptions& options, const RunConfig& config, const fs::path& scene,
               const std::vector<const ChosenTrajectory*>& chosen, Progress* progress) {
  const sim::WorldOptions as_run = config.world_options();
  const sim::ImportedScene imported = sim::ImportScene(scene, as_run.import);
  const auto world =
      std::make_shared<const sim::World>(scene.filename().string(), imported, as_run);
  const auto plan = PlanOf(scene, config.import.scale);
  const std::vector<AgentRow> agents = AgentRowsOf(config);
  std::map<long, SceneMap> storeys;  // by height of the start in half metres
  for (const ChosenTrajectory* one : chosen) {
    const EpisodeTrajectory& trajectory = one->trajectory;
    const double floor = trajectory.start.position.y();
    TopDownSpec spec;
    spec.floor_y = static_cast<float>(floor);
    const auto [storey, is_new] = storeys.try_emplace(std::lround(2.0 * floor));
    if (is_new) storey->second = MakeSceneMap(imported.mesh, world->navmesh(), plan, spec);
    const SceneMap& map = storey->second;
    const fs::path stem = options.out / one->name;
    TrajectoryPlotSpec plot;
    plot.belief = options.belief;
    plot.title = AgentTitle(trajectory.result.key.agent, agents);
    WriteFigure(TrajectoryPlot(map, trajectory, plot), stem);
    if (options.film) {
      FilmstripSpec film;
      film.title = plot.title;
      film.belief = options.belief;
      sim::WritePng(fs::path(stem) += "_film.png",
                    ToImage(Filmstrip(world, map, trajectory, film)));
    }
    progress->Advance();
  }
}

/// Returns how many there are.
int WriteCharts(const fs::path& run, const RunConfig& config, const fs::path& out) {
  const std::vector<EpisodeResult> results = ReadResults(run);
  const std::vector<AgentRow> agents = AgentRowsOf(config);
  const auto goals = GoalCountCharts(Summarize(results, agents), agents);
  const auto distances = DistanceCharts(results, agents);
  if (!goals.empty()) WriteFigure(ChartFigure(goals), out / "by_goals");
  if (!distances.empty()) WriteFigure(ChartFigure(distances), out / "by_distance");
  return (goals.empty() ? 0 : 1) + (distances.empty() ? 0 : 1);
}

void DrawEpisodes(const PlotOptions& options, const RunConfig& config,
                  const std::vector<ChosenTrajectory>& chosen) {
  std::map<fs::path, std::vector<const ChosenTrajectory*>> by_scene;
  for (const ChosenTrajectory& one : chosen) by_scene[one.trajectory.scene_file].push_back(&one);
  if (config.fingerprints) {
    for (const auto& [scene, ones] : by_scene) {
      RequireSceneOfRun(scene, ones.front()->trajectory.result.key.scene,
                        config.fingerprints->scenes);
    }
  }
  Progress progress("plots", static_cast<int>(chosen.size()));
  for (const auto& [scene, ones] : by_scene) DrawScene(options, config, scene, ones, &progress);
}

/// "1 chart", "2 charts".
std::string Count(std::size_t number, const char* what) {
  return fmt::format("{} {}{}", number, what, number == 1 ? "" : "s");
}

void Plot(PlotOptions options) {
  if (options.out.empty()) options.out = options.run / "plots";
  const RunConfig config = LoadRunConfig(options.run / "config.yaml");
  const std::vector<ChosenTrajectory> chosen = ChooseFrom(options);
  if (chosen.empty()) {
    fmt::print(stderr, "bulletnav: {} holds no trajectories: no episodes are drawn, charts alone\n",
               options.run.string());
  } else {
    DrawEpisodes(options, config, chosen);
  }
  const int charts = WriteCharts(options.run, config, options.out);
  fmt::print("{} and {} drawn in {}\n", Count(chosen.size(), "episode"),
             Count(static_cast<std::size_t>(charts), "chart"), options.out.string());
}

}  // namespace

void AddPlotCommand(CLI::App* program) {
  auto options = std::make_shared<PlotOptions>();
  CLI::App* command = program->add_subcommand(
      "plot", "Draw what agents did in a run: maps with paths, charts, filmstrips");
  command->add_option("run", options->run, "Folder of results")->required();
  CLI::Option* episode =
      command->add_option("--episode", options->choice.episode, "Only this episode");
  CLI::Option* worst =
      command
          ->add_option(
              "--worst", options->choice.worst,
              "Only so many, those of least SoftSPL; of equal ones each agent has one in turn, "
              "over the scenes in turn")
          ->check(CLI::Range(1, 1'000'000))
          ->excludes(episode);
  command
      ->add_flag("--all", options->choice.all,
                 fmt::format("All episodes (default: the first {})", kFirstPlots))
      ->excludes(episode)
      ->excludes(worst);
  command->add_option("--agent", options->choice.agent, "Only this agent");
  command->add_flag("--belief", options->belief, "Add the agent's own map or graph");
  command->add_flag("--film", options->film, "Add filmstrips of panoramas beside the map");
  command->add_option("--out", options->out, "Folder for the pictures (default: RUN/plots)");
  command->callback([options] {
    Plot(*options);
  });
}

}  // namespace bulletnav::bench
