// SPDX-License-Identifier: MIT
#include "benchmark/runs/run_config.h"

#include <algorithm>

#include <gmock/gmock.h>

#include "benchmark/runs/run_agents.h"
#include "sim/base/files.h"
#include "sim/config/yaml_writer.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::bench {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

constexpr const char* kGood =
    "episodes: {file: e.json}\n"
    "conditions: [noise, no_stop]\n"
    "agents:\n"
    "  - {agent: random, parameters: {stop: 0.5, forward: 0.25}}\n"
    "  - {agent: metric_map_fbe, models: {semantic_model: oracle}, settings: [rgbd]}\n"
    "  - {agent: shortest_path, name: ceiling}\n"
    "  - {agent: nts}\n";

std::string ErrorOf(const std::string& text) {
  try {
    ParseRunConfig(text, "c.yaml");
  } catch (const sim::FileError& e) {
    return e.what();
  }
  return "no error";
}

/// kGood with a part of it replaced.
std::string With(const std::string& part, const std::string& other) {
  std::string text = kGood;
  return text.replace(text.find(part), part.size(), other);
}

TEST(RunConfig, FillsInNamesAndParameters) {
  const RunConfig config = ParseRunConfig(kGood, "folder/night.yaml");
  EXPECT_EQ(config.name, "night");
  EXPECT_EQ(config.agents[0].name, "random");
  EXPECT_EQ(config.agents[2].name, "ceiling");
  EXPECT_THAT(sim::ToYaml(config), AllOf(HasSubstr("forward: 0.25"), HasSubstr("max_steps: 500"),
                                         HasSubstr("stop_distance: 0.5")));
}

TEST(RunConfig, SavedOneReadsBackTheSame) {
  RunConfig config = ParseRunConfig(kGood, "night.yaml");
  config.fingerprints = Fingerprints{"0123", {{"a.glb", "77e1"}}, {{"nts_rgbd", "5a5a"}}};
  const std::string text = sim::ToYaml(config);
  const RunConfig again = ParseRunConfig(text, "config.yaml");
  EXPECT_EQ(sim::ToYaml(again), text);
  EXPECT_EQ(again.fingerprints, config.fingerprints);
}

TEST(RunConfig, SensorNoiseIsOffUnlessItIsNamed) {
  EXPECT_EQ(sim::ToYaml(ParseRunConfig(kGood, "c.yaml")).find("sensor_noise"), std::string::npos);
  const RunConfig config =
      ParseRunConfig("sensor_noise: depth_camera\n" + std::string(kGood), "c.yaml");
  EXPECT_EQ(config.sensor_noise, "depth_camera");
  EXPECT_THAT(sim::ToYaml(config), HasSubstr("sensor_noise: depth_camera"));
  EXPECT_THAT(ErrorOf("sensor_noise: loud\n" + std::string(kGood)),
              AllOf(StartsWith("c.yaml:1:15: "), HasSubstr("none, depth_camera, phone_camera")));
}

TEST(RunConfig, ErrorsNameThePlace) {
  EXPECT_THAT(ErrorOf(With("conditions:", "condition:")),
              AllOf(StartsWith("c.yaml:2:1: "), HasSubstr("did you mean 'conditions'?")));
  EXPECT_THAT(ErrorOf(With("no_stop", "nostop")),
              AllOf(StartsWith("c.yaml:2:21: "), HasSubstr("noise, no_stop, no_noise")));
  EXPECT_THAT(ErrorOf(With("agent: random", "agent: randm")),
              AllOf(StartsWith("c.yaml:4:13: "), HasSubstr("did you mean 'random'?"),
                    HasSubstr("shortest_path")));
  EXPECT_THAT(ErrorOf(With("forward: 0.25", "forwrd: 0.25")),
              AllOf(StartsWith("c.yaml:4:"), HasSubstr("did you mean 'forward'?")));
  EXPECT_THAT(ErrorOf(With("stop: 0.5", "stop: 1.5")), HasSubstr("must be probabilities"));
  EXPECT_THAT(ErrorOf(With("{agent: nts}", "{agent: random}")),
              AllOf(StartsWith("c.yaml:7:5: "), HasSubstr("two agents are called 'random'")));
  EXPECT_THAT(ErrorOf(With("name: ceiling", "weight: 3")), StartsWith("c.yaml:6:28: unknown key"));
  EXPECT_THAT(ErrorOf(With("{agent: nts}", "{agent: nts, models: {brain: learned}}")),
              AllOf(StartsWith("c.yaml:7:"), HasSubstr("nts takes no model called 'brain'")));
  EXPECT_THAT(ErrorOf(With("[noise, no_stop]", "[noise, noise]")),
              AllOf(StartsWith("c.yaml:2:13: "), HasSubstr("a value twice")));
  EXPECT_THAT(ErrorOf("episodess: {file: e}\nagents: [{agent: nts}]\n"),
              AllOf(StartsWith("c.yaml:1:1: "), HasSubstr("did you mean 'episodes'?")));
  EXPECT_THAT(ErrorOf("name: ..\n" + std::string(kGood)), HasSubstr("must be a word"));
  EXPECT_THAT(ErrorOf("episodes: {file: e}\nagents: []\n"),
              AllOf(StartsWith("c.yaml:2:9: "), HasSubstr("'agents' is empty")));
  EXPECT_THAT(ErrorOf("agents: [{agent: nts}]\n"), HasSubstr("key 'episodes' is missing"));
}

TEST(RunConfig, ReadsWhatEarlierVersionsSaved) {
  const tests::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "config.yaml";
  sim::WriteFileAtomically(
      file,
      "episodes: {file: e.json}\nweights: {rgb: a, rgbd: b, mapper: c}\nagents:\n"
      "  - {agent: random, semantic_model: none}\n"
      "  - {agent: nts, semantic_model: oracle, oracle_functions: []}\n"
      "  - {agent: metric_map_fbe, semantic_model: learned, oracle_functions: []}\n"
      "fingerprints: {episodes: '01', scenes: {}, weights: {rgb: '2', mapper: '3'}}\n");
  const RunConfig config = LoadSavedRunConfig(file);
  using Names = std::map<std::string, std::string>;
  EXPECT_EQ(config.weights, (Names{{"mapper_rgb", "c"}, {"nts_rgb", "a"}, {"nts_rgbd", "b"}}));
  EXPECT_EQ(config.fingerprints->weights, (Names{{"mapper_rgb", "3"}, {"nts_rgb", "2"}}));
  EXPECT_TRUE(config.agents[0].models.empty());
  EXPECT_EQ(config.agents[1].models.at("semantic_model"), "oracle");
  EXPECT_EQ(config.agents[2].models.at("semantic_model"), "learned");
}

TEST(RunAgents, SayWhatIsMissing) {
  RunConfig config = ParseRunConfig(kGood, "c.yaml");
  config.settings = {"rgb", "rgbd"};
  for (const char* key : {"nts_rgb", "nts_rgbd", "mapper_rgb"}) config.weights[key] = "none";
  config.agents[1].settings.clear();
  const auto agents = FindAgents(config);
  EXPECT_EQ(agents[0].row().note, "");
  EXPECT_EQ(agents[1].settings, std::vector<std::string>{"rgbd"});
  EXPECT_THAT(agents[1].row().note, StartsWith("oracle; not in rgb: "));
  EXPECT_EQ(agents[2].row().note, "privileged");
  EXPECT_TRUE(agents[3].settings.empty());
  EXPECT_THAT(agents[3].row().note, HasSubstr("does not exist; docs/training.md"));
  try {
    RequireAll(agents);
    FAIL();
  } catch (const sim::Error& e) {
    EXPECT_THAT(e.what(), AllOf(HasSubstr("metric_map_fbe: not in rgb"), HasSubstr("nts: ")));
  }
  EXPECT_NO_THROW(RequireAll(std::span(agents).first(1)));
}

TEST(RunAgents, WithoutAnEstimatorAnAgentThatNeedsOneIsMissing) {
  const RunConfig config = ParseRunConfig(
      With("models: {semantic_model: oracle}", "models: {semantic_model: none}"), "c.yaml");
  EXPECT_THAT(FindAgents(config)[1].row().note,
              HasSubstr("needs a semantic model; 'models: {semantic_model"));
}

TEST(RunAgents, WithOracleFunctionsTheRowSaysSo) {
  const RunConfig config = ParseRunConfig(
      With("{agent: nts}", "{agent: nts, models: {semantic_model: oracle}}"), "c.yaml");
  EXPECT_EQ(FindAgents(config)[3].row().note, "oracle");
}

TEST(RunConfig, EveryShippedOneLoads) {
  int count = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(BULLETNAV_CONFIGS)) {
    const std::filesystem::path& file = entry.path();
    const bool is_run =
        file.extension() == ".yaml" && file.string().find("/configs/train/") == std::string::npos &&
        file.string().find("/configs/slam/") == std::string::npos &&
        !file.filename().string().starts_with("episodes") &&
        !file.filename().string().starts_with("perception") && file.stem() != "quantise" &&
        !file.filename().string().starts_with("stitch") && file.stem() != "evaluate_policy";
    if (!is_run) continue;
    ++count;
    const RunConfig config = LoadRunConfig(file);
    const auto agents = FindAgents(config);
    EXPECT_TRUE(std::any_of(agents.begin(), agents.end(), [](const RunAgent& agent) {
      return agent.missing.empty();
    })) << file;
    EXPECT_EQ(ParseRunConfig(sim::ToYaml(config), file).name, config.name);
  }
  EXPECT_GE(count, 9);
}

}  // namespace
}  // namespace bulletnav::bench
