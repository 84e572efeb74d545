// SPDX-License-Identifier: MIT
#include <filesystem>
#include <memory>
#include <string>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/core.h>

#include "benchmark/cli/commands.h"
#include "benchmark/cli/progress.h"
#include "benchmark/cli/shipped_config.h"
#include "benchmark/runs/agent_models.h"
#include "benchmark/training/rl/navigation/policy_evaluation.h"
#include "sim/config/yaml_reader.h"

namespace bulletnav::bench {
namespace {

struct PolicyOptions {
  std::filesystem::path config;
  std::string weights;
  int episodes = 0;
  int workers = 0;
  PolicyTrials trials;
  bool json = false;
};

void Evaluate(const PolicyOptions& options) {
  auto config = sim::LoadYaml<PolicyEvaluationConfig>(ShippedConfig(options.config));
  if (!options.weights.empty()) config.weights = options.weights;
  if (options.episodes > 0) config.episodes = options.episodes;
  const std::vector<PolicyEvaluationRow> rows = EvaluatePolicy(
      config, FindWeights(config.weights), options.trials, options.workers, {.start = StartLine});
  fmt::print("{}", options.json ? ToJson(rows) : ToText(rows));
}

}  // namespace

void AddEvaluatePolicyCommand(CLI::App* program) {
  auto options = std::make_shared<PolicyOptions>();
  CLI::App* command = program->add_subcommand(
      "evaluate-policy", "How a learned policy fares, and whether it does by what it sees");
  command->add_option("config", options->config, "YAML file, as configs/evaluate_policy.yaml")
      ->required();
  command->add_option("--weights", options->weights, "Instead of the config's");
  command->add_option("--episodes", options->episodes, "Instead of the config's, in each setting")
      ->check(CLI::Range(1, 100000));
  command->add_flag("--shuffle-goals", options->trials.shuffle_goals,
                    "Also with goals of other episodes: it should lose most of its success");
  command->add_flag("--blank-images", options->trials.blank_images,
                    "Also with pictures that show nothing: it should lose nearly all");
  command->add_flag("--direct-images", options->trials.direct_images,
                    "Also with pictures drawn in the policy's size, as trainings with draw: direct "
                    "show them: it should fare alike");
  command->add_option("--workers", options->workers, "Threads (default: one per processor)")
      ->check(CLI::Range(1, 1024));
  command->add_flag("--json", options->json, "Print JSON instead of a table");
  command->callback([options] {
    Evaluate(*options);
  });
}

}  // namespace bulletnav::bench
