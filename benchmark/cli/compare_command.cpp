// SPDX-License-Identifier: MIT
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/core.h>

#include "benchmark/cli/commands.h"
#include "benchmark/evaluation/comparison.h"
#include "benchmark/evaluation/result_store.h"

namespace bulletnav::bench {
namespace {

struct CompareOptions {
  std::filesystem::path first;
  std::filesystem::path second;
  std::vector<std::string> agents;
};

void Compare(const CompareOptions& options) {
  std::optional<std::pair<std::string, std::string>> agents;
  if (!options.agents.empty()) agents = {options.agents[0], options.agents[1]};
  fmt::print("{}",
             ToText(CompareRuns(ReadResults(options.first), ReadResults(options.second), agents)));
}

}  // namespace

void AddCompareCommand(CLI::App* program) {
  auto options = std::make_shared<CompareOptions>();
  CLI::App* command = program->add_subcommand(
      "compare", "Differences between two runs on the same episodes, with confidence");
  command->add_option("first", options->first, "Folder of results")->required();
  command->add_option("second", options->second, "Folder of results; may be the same")->required();
  command
      ->add_option("--agents", options->agents,
                   "An agent of the first and one of the second (default: those of one name)")
      ->expected(2);
  command->callback([options] {
    Compare(*options);
  });
}

}  // namespace bulletnav::bench
