// SPDX-License-Identifier: MIT
#include <memory>
#include <string>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/core.h>

#include "benchmark/cli/commands.h"
#include "benchmark/cli/draw_run.h"

namespace bulletnav::bench {
namespace {

void Plot(const DrawOptions& options) {
  const DrawnCount drawn = DrawRun(options);
  if (drawn.episodes == 0) {
    fmt::print(stderr, "bulletnav: {} holds no trajectories: no episodes are drawn, charts alone\n",
               options.run.string());
  }
  fmt::print("{} drawn in {}\n", ToText(drawn), PlotFolder(options).string());
}

}  // namespace

void AddPlotCommand(CLI::App* program) {
  auto options = std::make_shared<DrawOptions>();
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
  command->add_flag("--animate", options->animate,
                    "Add moving pictures (WebP): panoramas beside the map as the path grows");
  command->add_option("--out", options->out, "Folder for the pictures (default: RUN/plots)");
  command->callback([options] {
    Plot(*options);
  });
}

}  // namespace bulletnav::bench
