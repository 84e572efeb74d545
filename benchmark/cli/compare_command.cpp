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
#include "benchmark/runs/comparison.h"
#include "benchmark/runs/result_store.h"

namespace bulletnav::bench {
namespace {

struct CompareOptions {
  std::filesystem::path first;
  std::filesystem::path second;
  std::string against;
  bool markdown = false;
  std::vector<std::string> agents;
  std::vector<std::string> settings;
  std::vector<std::string> conditions;
};

Pairing::Names NamesOf(const std::vector<std::string>& two) {
  if (two.empty()) return std::nullopt;
  return std::pair{two[0], two[1]};
}

void Compare(const CompareOptions& options) {
  const Pairing pairing = {NamesOf(options.agents), NamesOf(options.settings),
                           NamesOf(options.conditions)};
  const std::vector<EpisodeResult> first = ReadResults(options.first);
  const std::vector<EpisodeResult> second = ReadResults(options.second);
  const Comparison comparison = options.against.empty()
                                    ? CompareRuns(first, second, pairing)
                                    : CompareWithAll(first, second, options.against, pairing);
  fmt::print("{}", options.markdown ? ToMarkdown(comparison) : ToText(comparison));
}

}  // namespace

void AddCompareCommand(CLI::App* program) {
  auto options = std::make_shared<CompareOptions>();
  CLI::App* command = program->add_subcommand(
      "compare", "Differences between two runs on the same episodes, with confidence");
  command->add_option("first", options->first, "Folder of results")->required();
  command->add_option("second", options->second, "Folder of results; may be the same")->required();
  CLI::Option* agents =
      command
          ->add_option("--agents", options->agents,
                       "An agent of the first and one of the second (default: those of one name)")
          ->expected(2);
  command
      ->add_option("--against", options->against,
                   "An agent of the first, with each other one of the second")
      ->excludes(agents);
  command->add_flag("--markdown", options->markdown, "A table for a page");
  command
      ->add_option("--settings", options->settings,
                   "A setting of the first and one of the second, as rgb rgbd")
      ->expected(2);
  command
      ->add_option("--conditions", options->conditions,
                   "A condition of the first and one of the second, as noise no_noise")
      ->expected(2);
  command->callback([options] {
    Compare(*options);
  });
}

}  // namespace bulletnav::bench
