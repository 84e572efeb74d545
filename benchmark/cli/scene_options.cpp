// SPDX-License-Identifier: MIT
#include "benchmark/cli/scene_options.h"

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "benchmark/cli/number_range.h"
#include "sim/config/yaml_reader.h"

namespace bulletnav::bench {

void SceneOptions::AddTo(CLI::App* command) {
  command
      ->add_option("file", file,
                   "Scene: .glb, .gltf, .obj, .ply, .dae, .scene_instance.json, .sdf or .world")
      ->required();
  AddImportOptions(command);
}

void SceneOptions::AddImportOptions(CLI::App* command) {
  command->add_option("--up", up, "Axis of the file that points up: auto|y|z")
      ->check(CLI::IsMember({"auto", "y", "z"}));
  command->add_option("--scale", scale, "Metres per unit of the file, 0.001 for millimetres")
      ->check(NumberFrom(1e-6, 1e6));
  command->add_flag("--ground-plane", ground_plane,
                    "Add a floor under the mesh, for scenes made without one");
  command->add_option("--doors", doors,
                      "How doors stand: as_built, open, closed, or as YAML "
                      "\"{open_share: 0.5, seed: 3}\"; see docs/scenes.md");
  command->add_option(
      "--finish", finish,
      "Another look, as YAML: \"{ceiling: false, surfaces: flat}\"; see docs/rendering.md");
}

sim::ImportOptions SceneOptions::import() const {
  sim::ImportOptions options;
  if (up == "y") options.up = sim::UpAxis::kY;
  if (up == "z") options.up = sim::UpAxis::kZ;
  options.scale = scale;
  options.ground_plane = ground_plane;
  if (!doors.empty()) options.doors = sim::LoadYamlText<sim::DoorSpec>(doors, "--doors");
  if (!finish.empty()) options.finish = sim::LoadYamlText<sim::Finish>(finish, "--finish");
  return options;
}

void AddBackendOption(CLI::App* command, sim::Backend* backend) {
  AddEnumOption(command, "--backend", backend,
                "Renderer; auto is EGL on a graphics processor, else Embree");
}

}  // namespace bulletnav::bench
