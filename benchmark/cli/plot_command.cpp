// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <system_error>
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
#include "benchmark/report/result_charts.h"
#include "benchmark/report/run_scene.h"
#include "benchmark/report/trajectory_plot.h"
#include "sim/base/error.h"
#include "sim/house/house_json.h"
#include "sim/image/image.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;

constexpr int kFirstPlots = 8;  // without --episode, --worst or --all

struct PlotOptions {
  fs::path run;
  fs::path out;
  std::string episode;
  std::string agent;
  int worst = 0;
  bool all = false;
  bool belief = false;
  bool film = false;
};

/// A trajectory and the name of its pictures, without extension, below the folder of plots.
struct Chosen {
  fs::path name;
  EpisodeTrajectory trajectory;
};

double MeanSoftSpl(const EpisodeTrajectory& trajectory) {
  double sum = 0.0;
  for (const GoalMetrics& goal : trajectory.result.goals) sum += goal.soft_spl;
  return sum / static_cast<double>(trajectory.result.goals.size());
}

/// All trajectories of a run, in the order of their files' names.
std::vector<Chosen> ReadAll(const fs::path& run) {
  const fs::path folder = run / "trajectories";
  std::error_code unreadable;
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder, unreadable)) {
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  }
  if (files.empty()) throw sim::FileError(folder, "", "holds no trajectories to plot");
  std::sort(files.begin(), files.end());
  std::vector<Chosen> chosen;
  chosen.reserve(files.size());
  for (const fs::path& file : files) {
    chosen.push_back({fs::relative(file, folder).replace_extension(), ReadTrajectory(file)});
  }
  return chosen;
}

std::vector<Chosen> Choose(const PlotOptions& options) {
  std::vector<Chosen> chosen = ReadAll(options.run);
  std::erase_if(chosen, [&](const Chosen& one) {
    const ResultKey& key = one.trajectory.result.key;
    return (!options.episode.empty() && key.episode != options.episode) ||
           (!options.agent.empty() && key.agent != options.agent);
  });
  if (chosen.empty()) {
    throw sim::Error(fmt::format("{}: has no trajectory of that episode and agent",
                                 (options.run / "trajectories").string()));
  }
  if (options.worst > 0) {
    std::stable_sort(chosen.begin(), chosen.end(), [](const Chosen& a, const Chosen& b) {
      return MeanSoftSpl(a.trajectory) < MeanSoftSpl(b.trajectory);
    });
  }
  const bool is_limited = !options.all && options.episode.empty();
  const std::size_t most =
      static_cast<std::size_t>(options.worst > 0 ? options.worst : kFirstPlots);
  if (is_limited && chosen.size() > most) chosen.resize(most);
  return chosen;
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
               const std::vector<const Chosen*>& chosen, Progress* progress) {
  const sim::WorldOptions as_run = config.world_options();
  const sim::ImportedScene imported = sim::ImportScene(scene, as_run.import);
  const auto world =
      std::make_shared<const sim::World>(scene.filename().string(), imported, as_run);
  const auto plan = PlanOf(scene, config.import.scale);
  const std::vector<AgentRow> agents = AgentRowsOf(config);
  std::map<long, SceneMap> storeys;  // by height of the start in half metres
  for (const Chosen* one : chosen) {
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
      sim::WritePng(fs::path(stem) += "_film.png",
                    ToImage(Filmstrip(world, map, trajectory, film)));
    }
    progress->Advance();
  }
}

void WriteCharts(const fs::path& run, const RunConfig& config, const fs::path& out) {
  const std::vector<EpisodeResult> results = ReadResults(run);
  const std::vector<AgentRow> agents = AgentRowsOf(config);
  const auto goals = GoalCountCharts(Summarize(results, agents), agents);
  const auto distances = DistanceCharts(results, agents);
  if (!goals.empty()) WriteFigure(ChartFigure(goals), out / "by_goals");
  if (!distances.empty()) WriteFigure(ChartFigure(distances), out / "by_distance");
}

void Plot(PlotOptions options) {
  if (options.out.empty()) options.out = options.run / "plots";
  const RunConfig config = LoadRunConfig(options.run / "config.yaml");
  const std::vector<Chosen> chosen = Choose(options);
  std::map<fs::path, std::vector<const Chosen*>> by_scene;
  for (const Chosen& one : chosen) by_scene[one.trajectory.scene_file].push_back(&one);
  if (config.fingerprints) {
    for (const auto& [scene, ones] : by_scene) {
      RequireSceneOfRun(scene, ones.front()->trajectory.result.key.scene,
                        config.fingerprints->scenes);
    }
  }
  {
    Progress progress("plots", static_cast<int>(chosen.size()));
    for (const auto& [scene, ones] : by_scene) DrawScene(options, config, scene, ones, &progress);
  }
  WriteCharts(options.run, config, options.out);
  fmt::print("{} episode{} drawn in {}\n", chosen.size(), chosen.size() == 1 ? "" : "s",
             options.out.string());
}

}  // namespace

void AddPlotCommand(CLI::App* program) {
  auto options = std::make_shared<PlotOptions>();
  CLI::App* command = program->add_subcommand(
      "plot", "Draw what agents did in a run: maps with paths, charts, filmstrips");
  command->add_option("run", options->run, "Folder of results")->required();
  CLI::Option* episode = command->add_option("--episode", options->episode, "Only this episode");
  CLI::Option* worst =
      command->add_option("--worst", options->worst, "Only so many, those of least SoftSPL")
          ->check(CLI::PositiveNumber)
          ->excludes(episode);
  command->add_flag("--all", options->all, "All episodes (default: the first 8)")
      ->excludes(episode)
      ->excludes(worst);
  command->add_option("--agent", options->agent, "Only this agent");
  command->add_flag("--belief", options->belief, "Add the agent's own map or graph");
  command->add_flag("--film", options->film, "Add filmstrips of panoramas beside the map");
  command->add_option("--out", options->out, "Folder for the pictures (default: RUN/plots)");
  command->callback([options] {
    Plot(*options);
  });
}

}  // namespace bulletnav::bench
