// SPDX-License-Identifier: MIT
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/core.h>

#include "benchmark/cli/commands.h"
#include "benchmark/cli/progress.h"
#include "benchmark/cli/shipped_config.h"
#include "benchmark/training/rl/navigation/policy_stitching.h"
#include "sim/base/require_writable.h"
#include "sim/config/override.h"
#include "sim/config/yaml_reader.h"

namespace bulletnav::bench {
namespace {

struct StitchOptions {
  std::filesystem::path config;
  std::filesystem::path out;
  std::vector<std::string> overrides;
};

}  // namespace

void AddStitchCommand(CLI::App* program) {
  auto options = std::make_shared<StitchOptions>();
  CLI::App* command = program->add_subcommand(
      "stitch", "Let a trained policy see with another encoder, to be trained on from there");
  command->add_option("config", options->config, "YAML file, as configs/stitch.yaml")->required();
  command->add_option("overrides", options->overrides,
                      "KEY=VALUE ...: set in the config, as weights=FILE or data.seed=2");
  command->add_option("--out", options->out, "File of weights to write")->required();
  command->callback([options] {
    const std::filesystem::path file = ShippedConfig(options->config);
    StitchConfig config;
    sim::YamlReader::Read(sim::ReadWithOverrides(file, options->overrides), config);
    sim::RequireWritable(options->out);
    const double explained = Stitch(config, options->out, {.start = StartLine});
    fmt::print("{:.1f}% of the variance of its codes is explained; written to {}\n",
               100.0 * explained, options->out.string());
  });
}

}  // namespace bulletnav::bench
