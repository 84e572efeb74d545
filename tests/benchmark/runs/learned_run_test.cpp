// SPDX-License-Identifier: MIT
// Runs of agents with learned functions; the weights are random, for what they find is not asked.
#include <algorithm>
#include <sstream>

#include <fmt/core.h>
#include <gmock/gmock.h>

#include "agent/perception/learned_mapper.h"
#include "agent/perception/learned_model.h"
#include "agent/perception/mapper_net.h"
#include "agent/perception/semantic_net.h"
#include "benchmark/runs/agent_models.h"
#include "benchmark/runs/result_store.h"
#include "benchmark/runs/runner.h"
#include "sim/base/error.h"
#include "sim/base/files.h"
#include "tests/support/houses.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

class LearnedRunTest : public testing::Test {
 protected:
  LearnedRunTest() {
    tests::WriteShellHouses(folder_.path(), 1, 1);
    WriteWeights(1);
    WriteMapper(1);
  }
  fs::path weights() const { return folder_.path() / "tiny.safetensors"; }
  fs::path mapper() const { return folder_.path() / "mapper.safetensors"; }
  void WriteMapper(std::uint64_t seed) const {
    agent::MapperConfig model;
    model.width = 8;
    model.rows = 32;
    model.features = 16;
    agent::SaveMapper(agent::MapperNet(model, seed), {}, agent::StoredType::kFloat32, mapper());
  }
  void WriteWeights(std::uint64_t seed,
                    agent::DepthFusion depth = agent::DepthFusion::kChannel) const {
    agent::ModelConfig model;
    model.depth = depth;
    model.width = 8;
    model.rows = 32;
    model.pair_features = 16;
    agent::SaveNet(agent::SemanticNet(model, seed), {}, agent::StoredType::kFloat32, weights());
  }
  RunConfig Config(const std::string& agents =
                       "{agent: nts, lanes: 2}, "
                       "{agent: metric_map_fbe}",
                   const std::string& more = "") const {
    return ParseRunConfig(
        fmt::format("name: test\nmax_steps: 12\nweights: {{nts_rgb: {}, nts_rgbd: {}, mapper_rgb: "
                    "{}}}\n{}\nepisodes:\n"
                    "  file: {}/episodes.json\n  draw:\n    houses: {{index: {}/index.json}}\n"
                    "    counts: {{easy: 3}}\nagents: [{}]\n",
                    weights().string(), weights().string(), mapper().string(), more,
                    folder_.path().string(), folder_.path().string(), agents),
        "test.yaml");
  }
  std::vector<std::string> Lines(const RunConfig& config, const std::string& name,
                                 int workers) const {
    RunOptions options;
    options.workers = workers;
    RunBenchmark(config, folder_.path() / name, options);
    std::istringstream file(sim::ReadTextFile(folder_.path() / name / "episodes.jsonl"));
    std::vector<std::string> lines;
    for (std::string line; std::getline(file, line);) lines.push_back(line);
    std::sort(lines.begin(), lines.end());
    return lines;
  }
  std::string Complaint(const RunConfig& config, const RunOptions& options) const {
    try {
      RunBenchmark(config, folder_.path() / "complaint", options);
    } catch (const sim::Error& e) {
      return e.what();
    }
    return "none";
  }

  tests::TemporaryFolder folder_;
};

TEST_F(LearnedRunTest, ResultsDoNotDependOnWorkers) {
  const auto one = Lines(Config(), "one", 1);
  EXPECT_EQ(one.size(), 6u);
  for (const std::string& line : one) EXPECT_THAT(line, Not(HasSubstr("failure\":\""))) << line;
  EXPECT_EQ(Lines(Config(), "two", 2), one);
}

TEST_F(LearnedRunTest, OtherWeightsAreNotMixedIntoResults) {
  Lines(Config(), "run", 1);
  WriteWeights(2);
  EXPECT_THROW(Lines(Config(), "run", 1), sim::Error);
  EXPECT_THROW(Lines(LoadRunConfig(folder_.path() / "run/config.yaml"), "again", 1), sim::Error);
}

TEST_F(LearnedRunTest, GoesOnWhenWeightsComeLater) {
  const std::string agents = "{agent: random}, {agent: nts}";
  const RunConfig config = Config(agents);
  fs::rename(weights(), folder_.path() / "aside");
  const auto before = Lines(config, "run", 1);
  EXPECT_EQ(before.size(), 3u);
  fs::rename(folder_.path() / "aside", weights());
  const auto after = Lines(config, "run", 1);
  EXPECT_EQ(after.size(), 6u);
  EXPECT_TRUE(std::includes(after.begin(), after.end(), before.begin(), before.end()));
  EXPECT_EQ(Lines(LoadRunConfig(folder_.path() / "run/config.yaml"), "again", 1), after);
  fs::remove(weights());
  EXPECT_THROW(Lines(LoadRunConfig(folder_.path() / "run/config.yaml"), "gone", 1), sim::Error);
}

TEST_F(LearnedRunTest, OneFileServesSettingsThatHaveNoneOfTheirOwn) {
  RunConfig config = Config("{agent: active_neural_slam, settings: [rgb, rgbd]}");
  config.weights["active_neural_slam"] = mapper().string();
  auto used = UsedWeights(config);
  EXPECT_EQ(used.at("active_neural_slam"), mapper());
  EXPECT_FALSE(used.contains("active_neural_slam_rgb"));
  config.weights["active_neural_slam_rgb"] = weights().string();
  used = UsedWeights(config);
  EXPECT_EQ(used.at("active_neural_slam_rgb"), weights());
  EXPECT_EQ(used.at("active_neural_slam"), mapper());  // in rgbd
  EXPECT_NO_THROW(RequireKnownWeights(config));
  // One that was named and is not there is missed, not replaced.
  config.weights["active_neural_slam_rgb"] = "none.safetensors";
  EXPECT_FALSE(UsedWeights(config).contains("active_neural_slam_rgb"));
}

TEST_F(LearnedRunTest, RowsSayWhatIsWrongWithWeights) {
  const auto note = [&](const RunConfig& config) {
    return FindAgents(config).front().row().note;
  };
  EXPECT_EQ(note(Config()), "");
  EXPECT_THAT(note(Config("{agent: nts}", "panorama: {rows: 64}")), HasSubstr("128 x 512"));
  std::string bytes = sim::ReadTextFile(weights());
  bytes[bytes.size() - 2] ^= 1;
  sim::WriteFileAtomically(weights(), bytes);
  EXPECT_THAT(note(Config()), HasSubstr("tiny.safetensors"));
  fs::remove(weights());
  EXPECT_THAT(note(Config()), AllOf(HasSubstr("does not exist"), HasSubstr("train")));
}

TEST_F(LearnedRunTest, PlaysNothingWithDamagedWeights) {
  RunOptions options;
  const RunConfig config = Config("{agent: random}, {agent: nts}");
  const std::string bytes = sim::ReadTextFile(weights());
  sim::WriteFileAtomically(weights(), bytes.substr(0, bytes.size() / 2));
  EXPECT_THAT(Complaint(config, options), HasSubstr("tiny.safetensors"));
  WriteMapper(1);
  fs::copy_file(mapper(), weights(), fs::copy_options::overwrite_existing);
  EXPECT_THAT(Complaint(config, options), HasSubstr("tiny.safetensors"));
  EXPECT_FALSE(fs::exists(folder_.path() / "complaint"));
}

TEST_F(LearnedRunTest, SaysWhyNothingCanBePlayed) {
  RunOptions options;
  const RunConfig config = Config("{agent: nts}");
  fs::remove(weights());
  EXPECT_THAT(Complaint(config, options), AllOf(HasSubstr("no agent can run: nts"),
                                                HasSubstr("does not exist; docs/training.md")));
  EXPECT_FALSE(fs::exists(folder_.path() / "complaint"));
}

TEST_F(LearnedRunTest, WithoutDepthAgentsMapByColour) {
  WriteWeights(1, agent::DepthFusion::kNone);
  const RunConfig config = Config(
      "{agent: nts, lanes: 2}, "
      "{agent: metric_map_fbe, models: {semantic_model: oracle}}",
      "settings: [rgb]");
  const auto one = Lines(config, "one", 1);
  EXPECT_EQ(one.size(), 6u);
  for (const std::string& line : one) EXPECT_THAT(line, Not(HasSubstr("failure\":\""))) << line;
  EXPECT_EQ(Lines(config, "two", 2), one);
  WriteMapper(2);
  EXPECT_THROW(Lines(LoadRunConfig(folder_.path() / "one/config.yaml"), "again", 1), sim::Error);
}

TEST_F(LearnedRunTest, RowsSayWhatIsWrongWithTheMapper) {
  const RunConfig config =
      Config("{agent: metric_map_fbe, models: {semantic_model: oracle}}", "settings: [rgb]");
  const auto note = [&] {
    return FindAgents(config).front().row().note;
  };
  EXPECT_EQ(note(), "oracle");
  WriteWeights(1, agent::DepthFusion::kNone);
  fs::copy_file(weights(), mapper(), fs::copy_options::overwrite_existing);
  EXPECT_THAT(note(), HasSubstr("holds no mapper, which 'mapper' takes"));
  fs::remove(mapper());
  EXPECT_THAT(note(), AllOf(HasSubstr("mapper.safetensors"), HasSubstr("does not exist")));
}

}  // namespace
}  // namespace bulletnav::bench
