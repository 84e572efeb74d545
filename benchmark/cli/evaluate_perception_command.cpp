// SPDX-License-Identifier: MIT
#include <filesystem>
#include <memory>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/core.h>

#include "agent/models/model_registry.h"
#include "agent/models/safetensors.h"
#include "agent/perception/integer_models.h"
#include "agent/perception/learned_model.h"
#include "benchmark/base/file_hash.h"
#include "benchmark/base/program_version.h"
#include "benchmark/cli/commands.h"
#include "benchmark/cli/progress.h"
#include "benchmark/cli/shipped_config.h"
#include "benchmark/evaluate_perception/perception_cases.h"
#include "benchmark/evaluate_perception/perception_charts.h"
#include "benchmark/evaluate_perception/perception_figures.h"
#include "benchmark/evaluate_perception/perception_pictures.h"
#include "benchmark/evaluate_perception/perception_report.h"
#include "benchmark/runs/agent_models.h"
#include "sim/base/files.h"
#include "sim/config/yaml_reader.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;

struct PerceptionOptions {
  fs::path config;
  std::string weights;
  std::string out;
  int workers = 0;
  bool json = false;
  bool trained = false;
};

PerceptionConfig ConfigOf(const PerceptionOptions& options) {
  auto config = sim::LoadYaml<PerceptionConfig>(ShippedConfig(options.config));
  if (!options.weights.empty()) config.weights = options.weights;
  if (!options.out.empty()) config.out = options.out;
  return config;
}

ModelMaker MakerOf(const fs::path& weights, const agent::Rig& rig, bool trained) {
  if (!trained && agent::HoldsIntegers(agent::ReadTensorFile(weights))) {
    return [=] {
      return agent::LoadIntegerModel(weights, rig);
    };
  }
  return [=] {
    return std::make_shared<agent::LearnedModel>(weights, rig);
  };
}

std::vector<SceneCases> Ask(const PerceptionConfig& config, const fs::path& weights, int workers,
                            bool trained) {
  const agent::Rig rig = {.panorama = config.data.panorama,
                          .camera_height = config.data.body.camera_height};
  const ModelMaker make_model = MakerOf(weights, rig, trained);
  make_model();  // before scenes are loaded: tells at once what is wrong with the weights
  MakeHousesOf(config.data, CommittedVersion(), workers, StartLine);
  const auto scenes = static_cast<int>(ScenesOf(config.data).size());
  Progress progress("places", scenes * config.data.points);
  CasesProgress telling;
  telling.on_place = [&] {
    progress.Advance();
  };
  telling.on_note = [](const std::string& note) {
    fmt::print(stderr, "{}\n", note);
  };
  return MakeCases(config.data, make_model, workers, telling);
}

void Draw(const std::vector<SceneCases>& cases, const PerceptionFigures& figures,
          const PerceptionConfig& config) {
  const fs::path out = config.out;
  WriteFigure(PrecisionRecallFigure(figures.connection), out / "precision_recall");
  WriteFigure(ConnectionBinsFigure(figures.connection), out / "connection");
  Progress progress("pictures", config.pictures);
  DrawExamples(cases, config, out, [&] {
    progress.Advance();
  });
}

void Evaluate(const PerceptionOptions& options) {
  const PerceptionConfig config = ConfigOf(options);
  const fs::path weights = FindWeights(config.weights);
  const fs::path out = config.out;
  sim::MakeFolder(out);
  const std::vector<SceneCases> cases = Ask(config, weights, options.workers, options.trained);
  const PerceptionFigures figures = MeasurePerception(cases, config);
  const PerceptionSource source = {config.weights, FileHash(weights), ProgramVersion()};
  const std::string json = ToJson(figures, config, source);
  const std::string markdown = ToMarkdown(figures, config, source);
  sim::WriteFileAtomically(out / "perception.json", json);
  sim::WriteFileAtomically(out / "perception.md", markdown);
  Draw(cases, figures, config);
  fmt::print("{}", options.json ? json : markdown);
  fmt::print(stderr, "written to {}\n", out.string());
}

}  // namespace

void AddEvaluatePerceptionCommand(CLI::App* program) {
  auto options = std::make_shared<PerceptionOptions>();
  CLI::App* command = program->add_subcommand("evaluate-perception",
                                              "How right the learned functions of Neural "
                                              "Topological SLAM are in scenes they have not seen");
  command->add_option("config", options->config, "YAML file, as configs/perception.yaml")
      ->required();
  command->add_option("--weights", options->weights, "Instead of the config's");
  command->add_option("--out", options->out, "Folder, instead of the config's");
  command->add_option("--workers", options->workers, "Threads (default: one per processor)")
      ->check(CLI::Range(1, 1024));
  command->add_flag("--trained", options->trained,
                    "Ask the trained network in floats, though the file holds one in integers");
  command->add_flag("--json", options->json, "Print JSON instead of tables");
  command->callback([options] {
    Evaluate(*options);
  });
}

}  // namespace bulletnav::bench
