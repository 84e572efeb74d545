// SPDX-License-Identifier: MIT
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include <fmt/core.h>

#include "benchmark/base/warn_line.h"
#include "benchmark/cli/commands.h"
#include "benchmark/cli/progress.h"
#include "benchmark/cli/scene_options.h"
#include "benchmark/report/room_labels.h"
#include "benchmark/report/scene_report.h"
#include "benchmark/report/top_down.h"
#include "sim/base/error.h"
#include "sim/base/require_writable.h"
#include "sim/house/house_json.h"

namespace bulletnav::bench {
namespace {

struct InspectOptions {
  SceneOptions scene;
  bool json = false;
  std::filesystem::path topdown;
};

/// Names for the rooms of a house that has its description beside it and is shown in its own size.
std::vector<MapLabel> LabelsFor(const SceneOptions& scene) {
  std::filesystem::path description = scene.file;
  description.replace_extension(".json");
  std::error_code unreadable;
  if (scene.scale != 1.0 || description == scene.file ||
      !std::filesystem::exists(description, unreadable)) {
    return {};
  }
  try {
    return RoomLabels(sim::ReadHouseJson(description).plan);
  } catch (const sim::Error& e) {
    WarnLine(std::string("the plan gets no room names: ") + e.what());
    return {};
  }
}

std::string RequirePng(const std::string& file) {
  return file.ends_with(".png") ? "" : file + " must end in .png";
}

void Inspect(const InspectOptions& options) {
  const std::string file = options.scene.file.string();
  if (!options.topdown.empty()) sim::RequireWritable(options.topdown);
  std::optional<Progress> progress(std::in_place, "reading " + file);
  const sim::ImportedScene scene = sim::ImportScene(options.scene.file, options.scene.import());
  progress->Rename("finding the walkable floor of " + file);
  const sim::Navmesh navmesh(scene.mesh, {}, file);
  progress->Rename("measuring " + file);
  SceneReport report = InspectScene(scene.report, navmesh);
  report.doors = scene.doors;
  if (!options.topdown.empty()) {
    progress->Rename("drawing " + options.topdown.string());
    sim::WritePng(options.topdown, DrawTopDown(scene.mesh, navmesh, LabelsFor(options.scene)));
  }
  progress.reset();
  fmt::print("{}", options.json ? ToJson(report) : ToText(report));
  sim::RequireFloor(file, scene.report, navmesh);
}

void AddInspect(CLI::App* scenes) {
  auto options = std::make_shared<InspectOptions>();
  CLI::App* command =
      scenes->add_subcommand("inspect", "Say what a scene holds and where one can walk in it");
  options->scene.AddTo(command);
  command->add_flag("--json", options->json, "Print JSON");
  command
      ->add_option("--topdown", options->topdown,
                   "Draw the floor plan with the walkable area into this PNG, with room names "
                   "if the house's description is beside it (FILE's name with .json)")
      ->check(RequirePng);
  command->callback([options] {
    Inspect(*options);
  });
}

}  // namespace

void AddScenesCommand(CLI::App* program) {
  CLI::App* scenes = program->add_subcommand("scenes", "Make, inspect and export scenes");
  scenes->require_subcommand(1);
  AddGenerateCommand(scenes);
  AddInspect(scenes);
  AddExportCommand(scenes);
}

}  // namespace bulletnav::bench
