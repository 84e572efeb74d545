// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <map>
#include <string>

#include <CLI/App.hpp>

#include "sim/world.h"

namespace bulletnav::bench {

/// The options of every command that loads a scene.
struct SceneOptions {
  std::filesystem::path file;
  std::string up = "auto";
  double scale = 1.0;
  bool ground_plane = false;
  std::string doors;   // sim::DoorSpec as YAML; empty: as built
  std::string finish;  // sim::Finish as YAML; empty: none

  /// Adds FILE and the options to a command.
  void AddTo(CLI::App* command);
  /// Adds the options alone.
  void AddImportOptions(CLI::App* command);
  /// Throws sim::FileError if doors or finish cannot be read.
  sim::ImportOptions import() const;
};

/// Adds --backend with the names of sim::Backend.
void AddBackendOption(CLI::App* command, sim::Backend* backend);

/// Adds an option whose value is one of an enum's YAML names.
template <class E>
CLI::Option* AddEnumOption(CLI::App* command, const std::string& name, E* value,
                           const std::string& help) {
  std::map<std::string, E> names;
  for (const auto& [text, enumerator] : sim::EnumNames<E>::kNames) names[text] = enumerator;
  std::string shown;
  for (const auto& [text, enumerator] : sim::EnumNames<E>::kNames) {
    shown += (shown.empty() ? "" : "|") + std::string(text);
  }
  return command->add_option_function<std::string>(
      name,
      [name, value, names, shown](const std::string& text) {
        const auto found = names.find(text);
        if (found == names.end()) {
          throw CLI::ValidationError(name, "'" + text + "' is not one of " + shown);
        }
        *value = found->second;
      },
      help + ": " + shown);
}

}  // namespace bulletnav::bench
