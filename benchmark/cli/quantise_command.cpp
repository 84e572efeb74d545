// SPDX-License-Identifier: MIT
#include <filesystem>
#include <memory>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/core.h>

#include "agent/integer/quantised_file.h"
#include "agent/models/safetensors.h"
#include "agent/perception/model_file.h"
#include "agent/perception/quantise.h"
#include "benchmark/base/program_version.h"
#include "benchmark/cli/commands.h"
#include "benchmark/cli/progress.h"
#include "benchmark/cli/shipped_config.h"
#include "benchmark/evaluate_perception/perception_config.h"
#include "benchmark/runs/agent_models.h"
#include "benchmark/training/supervised/calibration.h"
#include "sim/base/error.h"
#include "sim/base/require_writable.h"
#include "sim/config/yaml_reader.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;

struct QuantiseOptions {
  fs::path config;
  std::string weights;
  std::string out;
};

void QuantiseFile(const QuantiseOptions& options) {
  auto config = sim::LoadYaml<PerceptionConfig>(ShippedConfig(options.config));
  if (!options.weights.empty()) config.weights = options.weights;
  const fs::path weights = FindWeights(config.weights);
  const fs::path out = options.out.empty() ? weights : fs::path(options.out);
  const agent::TensorFile content = agent::ReadTensorFile(weights);
  const bool is_mapper = content.metadata.contains(agent::kMapperKey);
  if (!is_mapper && !content.metadata.contains(agent::kModelKey)) {
    throw sim::FileError(weights, "",
                         "holds neither a semantic model nor a mapper; policies are put in "
                         "integers by `bulletnav train` itself");
  }
  sim::RequireWritable(out);
  MakeHousesOf(config.data, CommittedVersion(), 0, StartLine);
  torch::Tensor input;
  if (is_mapper) {
    const auto net = agent::LoadMapper(weights);
    input = CalibrationInput(config.data, net->config().seeing());
    agent::AddQuantised(agent::Quantise(*net, input), weights, out);
  } else {
    const auto net = agent::LoadNet(weights);
    input = CalibrationInput(config.data, net->config());
    agent::AddQuantised(agent::Quantise(*net, input), weights, out);
  }
  fmt::print("quantised by {} panoramas, written to {}\n", input.size(0), out.string());
}

}  // namespace

void AddQuantiseCommand(CLI::App* program) {
  auto options = std::make_shared<QuantiseOptions>();
  CLI::App* command = program->add_subcommand(
      "quantise", "Put a network in integers beside the trained one in a file of weights");
  command
      ->add_option("config", options->config,
                   "YAML file, as configs/perception.yaml: scenes like those of training")
      ->required();
  command->add_option("--weights", options->weights, "Instead of the config's");
  command->add_option("--out", options->out, "File to write (default: the weights themselves)");
  command->callback([options] {
    QuantiseFile(*options);
  });
}

}  // namespace bulletnav::bench
