// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>

#include <CLI/App.hpp>

namespace bulletnav::bench {

/// Adds --out for the folder of results of a run, which is results/NAME without it; an empty one,
/// as of a variable that is not set, is refused.
inline void AddResultsOption(CLI::App* command, std::filesystem::path* out) {
  command->add_option("--out", *out, "Folder of results (default: results/NAME)")
      ->check([](const std::string& text) {
        return std::string(text.empty() ? "is empty; is a shell variable not set?" : "");
      });
}

}  // namespace bulletnav::bench
