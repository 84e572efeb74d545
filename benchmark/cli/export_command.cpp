// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include <fmt/core.h>

#include "benchmark/base/warn_line.h"
#include "benchmark/cli/commands.h"
#include "benchmark/cli/progress.h"
#include "benchmark/cli/scene_options.h"
#include "sim/base/error.h"
#include "sim/scene/export_scene.h"

namespace bulletnav::bench {
namespace {

struct ExportOptions {
  SceneOptions scene;
  std::string format;
  std::string name;
  std::filesystem::path out;
};

/// As the scene is called, with what file names should not have replaced.
std::string NameOf(const std::filesystem::path& file) {
  std::string name = file.filename().string();
  name.resize(std::min(name.find('.'), name.size()));
  for (char& c : name) {
    const bool is_plain = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') ||
                          (c >= 'A' && c <= 'Z') || c == '-' || c == '_';
    if (!is_plain) c = '_';
  }
  return name;
}

/// With the hinges of doors, where they can be found: what lies beside the mesh may be of something
/// else, and nobody has asked to turn a door.
sim::ImportedScene Read(const SceneOptions& options) {
  sim::ImportOptions import = options.import();
  if (import.doors) return sim::ImportScene(options.file, import);
  std::string trouble;
  try {
    import.doors.emplace();
    return sim::ImportScene(options.file, import);
  } catch (const sim::FileError& e) {
    trouble = e.what();
  }
  import.doors.reset();
  sim::ImportedScene scene = sim::ImportScene(options.file, import);
  WarnLine("doors are exported without hinges: " + trouble);
  return scene;
}

void Export(const ExportOptions& options) {
  const std::string file = options.scene.file.string();
  std::optional<Progress> progress(std::in_place, "reading " + file);
  const sim::ImportedScene scene = Read(options.scene);
  progress->Rename("writing " + options.out.string());
  const auto format =
      options.format == "sdf" ? sim::SceneFormat::kSdf : sim::SceneFormat::kSceneInstance;
  const std::string name = options.name.empty() ? NameOf(options.scene.file) : options.name;
  const std::filesystem::path made =
      sim::ExportScene(scene.mesh, name, format, options.out, scene.doors);
  progress.reset();
  fmt::print("{}\n", made.string());
}

}  // namespace

void AddExportCommand(CLI::App* scenes) {
  auto options = std::make_shared<ExportOptions>();
  CLI::App* command = scenes->add_subcommand(
      "export", "Write a scene for Gazebo or Habitat, with its objects as files of their own");
  options->scene.AddTo(command);
  command
      ->add_option("--format", options->format,
                   "sdf: a world of Gazebo; scene_instance: a scene of Habitat with its data set")
      ->required()
      ->check(CLI::IsMember({"sdf", "scene_instance"}));
  command->add_option("--out", options->out, "Folder to write to; may hold other scenes")
      ->required();
  command->add_option("--name", options->name,
                      "What the scene is called; FILE's name if not given");
  command->callback([options] {
    Export(*options);
  });
}

}  // namespace bulletnav::bench
