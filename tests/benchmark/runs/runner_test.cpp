// SPDX-License-Identifier: MIT
#include "benchmark/runs/runner.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <functional>
#include <map>
#include <mutex>
#include <sstream>
#include <thread>

#include <fmt/core.h>
#include <gmock/gmock.h>

#include "benchmark/episodes/episode_file.h"
#include "benchmark/play/trajectory.h"
#include "benchmark/report/run_tables.h"
#include "benchmark/runs/result_store.h"
#include "benchmark/runs/run_play.h"
#include "sim/base/files.h"
#include "tests/support/houses.h"
#include "tests/support/killed.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::agent {
namespace {

/// How the agents below misbehave in one of three episodes, chosen by the seed.
enum class Trouble { kThrow, kNoAction, kNothing };

template <Trouble trouble>
class TroubledAgent final : public Agent {
 public:
  static constexpr std::string_view kName = trouble == Trouble::kThrow      ? "throws"
                                            : trouble == Trouble::kNoAction ? "no_action"
                                                                            : "behaves";
  struct Config {
    template <class V>
    void Visit(V& /*v*/) {}
  };
  TroubledAgent(const Config& /*config*/, const AgentContext& /*context*/) {}

  void Reset(const Panorama& /*goal*/, std::uint64_t seed) override {
    seed_ = seed;
    steps_ = 0;
  }
  sim::Action Act(const Observation& observation) override {
    if (++steps_ == 5 && seed_ % 3 == 0) Misbehave();
    if (steps_ == 9 && seed_ % 3 == 0 && trouble == Trouble::kNoAction) {
      return static_cast<sim::Action>(17);
    }
    if (steps_ > 40) return sim::Action::kStop;
    return observation.collided ? sim::Action::kTurnLeft : sim::Action::kMoveForward;
  }

 private:
  void Misbehave() const {
    if (trouble == Trouble::kThrow) throw sim::Error("lost at step 5");
  }

  std::uint64_t seed_ = 0;
  int steps_ = 0;
};

const AgentRegistration<TroubledAgent<Trouble::kThrow>> throws;
const AgentRegistration<TroubledAgent<Trouble::kNoAction>> no_action;
const AgentRegistration<TroubledAgent<Trouble::kNothing>> behaves;

}  // namespace
}  // namespace bulletnav::agent

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

/// Runs in two bare houses.
class RunnerTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    houses_ = new tests::TemporaryFolder;
    tests::WriteShellHouses(houses_->path(), 2, 2);
  }
  static void TearDownTestSuite() {
    delete houses_;
    houses_ = nullptr;
  }

  static RunConfig Config(const std::string& agents, const std::string& more = "",
                          const std::string& counts = "{easy: 3, medium: 3}") {
    const std::string folder = houses_->path().string();
    const std::string text = fmt::format(
        "name: test\npanorama: {{rows: 16, cols: 64}}\nmax_steps: 60\n{}\nepisodes:\n"
        "  file: {}/episodes_{}.json\n  draw:\n    houses: {{index: {}/index.json}}\n"
        "    counts: {}\n    sequential_goals: 3\nagents: [{}]\n",
        more, folder, sim::Hash64(counts), folder, counts, agents);
    return ParseRunConfig(text, "test.yaml");
  }
  fs::path folder(const std::string& name) const { return temporary_.path() / name; }
  std::vector<EpisodeResult> Play(const RunConfig& config, const std::string& name,
                                  int workers = 2) const {
    RunBenchmark(config, folder(name), {.episodes = {}, .workers = workers, .require_all = false});
    return ReadResults(folder(name));
  }
  /// The lines of episodes.jsonl, and after each its trajectory.
  std::string Bytes(const std::string& name) const {
    std::istringstream file(sim::ReadTextFile(folder(name) / "episodes.jsonl"));
    std::vector<std::string> lines;
    for (std::string line; std::getline(file, line);) lines.push_back(line);
    std::string bytes;
    for (const std::string& line : lines) {
      bytes += line + "\n" +
               sim::ReadTextFile(TrajectoryPath(folder(name), FromJsonLine(line, "x", 1).key));
    }
    return bytes;
  }

 private:
  static tests::TemporaryFolder* houses_;
  tests::TemporaryFolder temporary_;
};

tests::TemporaryFolder* RunnerTest::houses_ = nullptr;

constexpr const char* kAgents =
    "{agent: shortest_path}, {agent: random}, {agent: metric_map_fbe, models: {semantic_model: "
    "oracle}}, "
    "{agent: nts, models: {semantic_model: oracle}}, {agent: active_neural_slam, models: "
    "{semantic_model: oracle, exploration: gone.safetensors}}";

TEST_F(RunnerTest, AnyNumberOfWorkersGivesTheSameBytes) {
  const RunConfig config = Config(kAgents, "conditions: [noise, no_noise]\nseeds: [3, 4]");
  EXPECT_EQ(Play(config, "one", 1).size(), 4u * 2u * 2u * 6u);
  Play(config, "many", 5);
  EXPECT_EQ(Bytes("one"), Bytes("many"));
  for (const char* name : {"one", "many"}) RebuildTables(folder(name));
  for (const char* file :
       {"config.yaml", "summary.json", "table.md", "table.csv", "table.tex", "scenes.md"}) {
    EXPECT_EQ(sim::ReadTextFile(folder("one") / file), sim::ReadTextFile(folder("many") / file));
  }
  const std::string table = sim::ReadTextFile(folder("one") / "table.md");
  EXPECT_THAT(table,
              AllOf(HasSubstr("oracle"), HasSubstr("privileged"), HasSubstr("gone.safetensors")));
  fs::remove(folder("one") / "table.md");
  EXPECT_EQ(RebuildTables(folder("one")),
            table + "\n" + sim::ReadTextFile(folder("one") / "scenes.md"));
  EXPECT_EQ(sim::ReadTextFile(folder("one") / "table.md"), table);
}

TEST_F(RunnerTest, KilledAtAnyMomentItGoesOnToTheSameBytes) {
  const RunConfig config = Config(kAgents);
  Play(config, "whole");
  const int kills = tests::KillUntilDone(
      [&] {
        RunBenchmark(config, folder("killed"),
                     {.episodes = {}, .workers = 2, .require_all = false});
      },
      std::chrono::milliseconds(20),
      [](tests::Delay delay) {
        return delay + std::chrono::milliseconds(35);
      });
  EXPECT_GT(kills, 2);
  EXPECT_EQ(Bytes("killed"), Bytes("whole"));
}

TEST_F(RunnerTest, TroubledAgentsFailTheirEpisodesAndNothingElse) {
  const auto alone = Play(Config("{agent: behaves}"), "alone");
  const RunConfig config = Config("{agent: throws}, {agent: no_action}, {agent: behaves}");
  const RunOutcome outcome =
      RunBenchmark(config, folder("all"), {.episodes = {}, .workers = 2, .require_all = true});
  std::map<std::string, std::vector<EpisodeResult>> by_agent;
  for (const EpisodeResult& result : ReadResults(folder("all"))) {
    by_agent[result.key.agent].push_back(result);
  }
  EXPECT_EQ(by_agent["behaves"], alone);
  const std::map<std::string, std::string> reasons = {
      {"throws", "threw: lost at step 5"}, {"no_action", "answered 17, which is no action"}};
  int failed = 0;
  for (const auto& [agent, reason] : reasons) {
    ASSERT_EQ(by_agent[agent].size(), alone.size());
    for (std::size_t i = 0; i < alone.size(); ++i) {
      const EpisodeResult& result = by_agent[agent][i];
      if (result.failure.empty()) {
        EXPECT_EQ(result.goals, alone[i].goals);
        continue;
      }
      ++failed;
      EXPECT_EQ(result.failure, reason);
      EXPECT_FALSE(result.goals[0].success());
      EXPECT_EQ(result.goals[0].Whole("steps"), agent == "no_action" ? 8 : 4);
    }
  }
  EXPECT_GE(failed, 2);
  EXPECT_THAT(RebuildTables(folder("all")), HasSubstr("of them failed"));
  EXPECT_EQ(outcome.failures.size(), 2u);
  EXPECT_THAT(outcome.failures, testing::Contains(HasSubstr("of throws failed, as ")));
  EXPECT_THAT(outcome.failures, testing::Contains(HasSubstr("threw: lost at step 5")));
}

TEST_F(RunnerTest, FailedEpisodesArePlayedAgainWhereAsked) {
  const RunConfig config = Config("{agent: throws}, {agent: behaves}");
  const auto first = Play(config, "run");
  std::size_t failed = 0;
  for (const EpisodeResult& result : first) failed += result.failure.empty() ? 0u : 1u;
  ASSERT_GT(failed, 0u);
  std::size_t played = 0;
  RunHooks hooks;
  hooks.finish = [&](const EpisodeResult& result) {
    EXPECT_EQ(result.key.agent, "throws");
    ++played;
  };
  RunBenchmark(config, folder("run"),
               {.episodes = {}, .workers = 2, .require_all = false, .retry_failed = true}, hooks);
  EXPECT_EQ(played, failed);
  EXPECT_EQ(ReadResults(folder("run")), first);
}

TEST_F(RunnerTest, ResultsOfAgentsThatAreGoneCanStillBeShown) {
  Play(Config("{agent: behaves}, {agent: random}"), "run");
  const fs::path file = folder("run") / "config.yaml";
  std::string saved = sim::ReadTextFile(file);
  const std::string there = "agent: behaves";
  saved.replace(saved.find(there), there.size(), "agent: gone");
  const std::string stop = "stop: ";
  saved.replace(saved.find(stop, saved.find("agent: random")), stop.size(), "halt: ");
  sim::WriteFileAtomically(file, saved);
  EXPECT_THROW(LoadRunConfig(file), sim::Error);
  const std::string table = RebuildTables(folder("run"));
  EXPECT_THAT(table,
              AllOf(HasSubstr("| behaves |"), HasSubstr("| random |"), HasSubstr("no such agent")));
}

TEST_F(RunnerTest, LanesChangeNothingNotEvenBesideOneThatFails) {
  for (const char* agent : {"behaves", "throws"}) {
    const std::string name = agent;
    const auto one = Play(Config("{agent: " + name + "}"), name);
    const auto three = Play(Config("{agent: " + name + ", lanes: 3}"), name + "3", 1);
    EXPECT_EQ(one, three);
  }
}

TEST_F(RunnerTest, WithoutStopNoAgentDoesWorse) {
  const auto results = Play(Config(kAgents, "conditions: [noise, no_stop]"), "both");
  int stop = 0;
  int no_stop = 0;
  for (const EpisodeResult& result : results) {
    if (result.key.condition != "noise") continue;
    const auto other = std::find_if(results.begin(), results.end(), [&](const auto& candidate) {
      ResultKey key = result.key;
      key.condition = "no_stop";
      return candidate.key == key;
    });
    ASSERT_NE(other, results.end());
    EXPECT_GE(other->goals[0].success(), result.goals[0].success());
    stop += result.goals[0].success() ? 1 : 0;
    no_stop += other->goals[0].success() ? 1 : 0;
  }
  EXPECT_GE(no_stop, stop);
  EXPECT_GT(stop, 0);
}

TEST_F(RunnerTest, SequencesGoOnFromGoalToGoal) {
  RunConfig config = Config("{agent: shortest_path}, {agent: throws}", "", "{sequential: 4}");
  config.max_steps = 300;
  const auto results = Play(config, "sequence");
  for (const EpisodeResult& result : results) {
    ASSERT_EQ(result.goals.size(), 3u);
    const EpisodeTrajectory trajectory =
        ReadTrajectory(TrajectoryPath(folder("sequence"), result.key));
    EXPECT_EQ(trajectory.result, result);
    if (result.key.agent == "shortest_path") {
      for (const GoalMetrics& goal : result.goals) EXPECT_TRUE(goal.success());
    } else if (!result.failure.empty()) {
      EXPECT_FALSE(result.goals[2].success());
    }
  }
}

TEST_F(RunnerTest, FewerEpisodesFirstThenMore) {
  const RunConfig config = Config("{agent: random}, {agent: shortest_path}");
  RunBenchmark(config, folder("parts"), {.episodes = 2, .workers = 1, .require_all = false});
  EXPECT_EQ(ReadResults(folder("parts")).size(), 4u);
  std::size_t total = 0;
  std::size_t before = 0;
  std::size_t told = 0;
  RunHooks hooks;
  hooks.begin = [&](std::size_t all, std::span<const EpisodeResult> done) {
    total = all;
    before = done.size();
  };
  hooks.finish = [&](const EpisodeResult&) {
    ++told;
  };
  RunBenchmark(config, folder("parts"), {}, hooks);
  EXPECT_EQ(total, 12u);
  EXPECT_EQ(before, 4u);
  EXPECT_EQ(told, 8u);
  Play(config, "whole");
  EXPECT_EQ(Bytes("parts"), Bytes("whole"));
}

TEST_F(RunnerTest, StagesCanBeCalledAloneAndImportEachSceneOnce) {
  ResolvedRun run = ResolveRun(Config("{agent: shortest_path}", "", "{easy: 4}"), true);
  fs::remove(run.config.episodes.file);
  SceneCache scenes(run.config.world_options());
  const RunTools tools = {scenes,
                          2,
                          [](const std::string&, int) {
                            return [] {};
                          },
                          {}};
  EXPECT_TRUE(DrawRunEpisodes(run.config, tools));
  EXPECT_FALSE(DrawRunEpisodes(run.config, tools));
  RunEpisodes episodes = ReadRunEpisodes(run.config);
  EXPECT_EQ(episodes.episodes.size(), 4u);
  CheckRunEpisodes(run.config, tools, &episodes);
  EXPECT_EQ(TakeFingerprints(run.config, episodes, &scenes).scenes.size(), 2u);
  const RunPlan plan = PlanRun(std::move(run), std::move(episodes));
  std::mutex adding;
  std::vector<EpisodeResult> results;
  PlayJobs(plan, JobsOf(plan), 2, &scenes,
           [&](const EpisodeTrajectory& trajectory, const BeliefLog&) {
             const std::lock_guard lock(adding);
             results.push_back(trajectory.result);
           });
  EXPECT_EQ(scenes.imports(), 2);
  EXPECT_EQ(scenes.kept_bytes(), 0u);
  EXPECT_EQ(Summarise(plan, "x", results).results.size(), 4u);
}

/// Names and bytes of the beliefs of a run.
std::map<std::string, std::string> Beliefs(const fs::path& run) {
  std::map<std::string, std::string> files;
  if (!fs::exists(run / "beliefs")) return files;
  for (const auto& entry : fs::recursive_directory_iterator(run / "beliefs")) {
    if (!entry.is_regular_file()) continue;
    files[fs::relative(entry.path(), run).string()] = sim::ReadTextFile(entry.path());
  }
  return files;
}

TEST_F(RunnerTest, LogsBeliefsBesideResultsThatDoNotChange) {
  const std::string agents =
      "{agent: metric_map_fbe, models: {semantic_model: oracle}}, "
      "{agent: random}";
  Play(Config(agents), "without", 1);
  EXPECT_TRUE(Beliefs(folder("without")).empty());
  Play(Config(agents, "beliefs: true"), "with", 2);
  RunBenchmark(Config(agents), folder("flag"),
               {.episodes = {}, .workers = 1, .require_all = false, .shard = {}, .beliefs = true});
  EXPECT_EQ(Bytes("without"), Bytes("with"));
  EXPECT_EQ(sim::ReadTextFile(folder("without") / "config.yaml"),
            sim::ReadTextFile(folder("with") / "config.yaml"));
  EXPECT_EQ(Beliefs(folder("with")).size(), 6u) << "random believes nothing";
  EXPECT_EQ(Beliefs(folder("with")), Beliefs(folder("flag")));
}

TEST_F(RunnerTest, RefusesAFolderOfAnotherConfigOrRun) {
  const auto complaint = [&](const RunConfig& config) -> std::string {
    try {
      RunBenchmark(config, folder("taken"), {});
    } catch (const sim::Error& e) {
      return e.what();
    }
    return "nothing";
  };
  Play(Config("{agent: random}"), "taken");
  EXPECT_EQ(complaint(Config("{agent: random}")), "nothing");
  EXPECT_THAT(complaint(Config("{agent: random, parameters: {stop: 0.02}}")),
              AllOf(HasSubstr("of another config"), HasSubstr("stop: 0.02")));
  EXPECT_THAT(complaint(Config("{agent: random}", "seeds: [5]")), HasSubstr("of another config"));
  const sim::FolderLock other(folder("taken"));
  EXPECT_THAT(complaint(Config("{agent: random}")), HasSubstr("another run"));
}

TEST_F(RunnerTest, SavedConfigRunsAgainAndOtherEpisodesAreRefused) {
  Play(Config("{agent: random}"), "first");
  RunConfig saved = LoadRunConfig(folder("first") / "config.yaml");
  Play(saved, "second");
  EXPECT_EQ(Bytes("first"), Bytes("second"));
  saved.fingerprints->episodes = "0";
  EXPECT_THROW(Play(saved, "third"), sim::FileError);
}

TEST_F(RunnerTest, EpisodesThatCannotBePlayedAreRefusedBeforeTheRun) {
  RunConfig config = Config("{agent: random}");
  Play(config, "good");
  const EpisodeSet good = ReadEpisodes(config.episodes.file);
  const fs::path bad = folder("bad.json");
  config.episodes.file = bad.string();
  config.episodes.draw.reset();
  const auto complaint = [&](const std::function<void(Episode*)>& spoil) -> std::string {
    EpisodeSet set = good;
    spoil(&set.episodes[3]);
    WriteEpisodes(bad, set);
    try {
      RunBenchmark(config, folder("bad"), {});
    } catch (const sim::Error& e) {
      return e.what();
    }
    return "nothing";
  };
  EXPECT_EQ(complaint([](Episode*) {}), "nothing");
  EXPECT_THAT(complaint([](Episode* episode) {
                episode->scene = "nowhere.glb";
              }),
              HasSubstr("scene nowhere.glb: no such file"));
  EXPECT_THAT(complaint([](Episode* episode) {
                episode->start_position.x() += 500.0;
              }),
              AllOf(HasSubstr("bad.json: episode '" + good.episodes[3].id + "'"),
                    HasSubstr("start: there is no floor")));
}

TEST_F(RunnerTest, EpisodesOfOthersThatAreNotThereAreAskedFor) {
  RunConfig config = Config("{agent: random}");
  config.episodes.draw.reset();
  config.episodes.file = folder("none.json.gz").string();
  const auto run = [&] {
    RunBenchmark(config, folder("out"), {});
  };
  EXPECT_THAT(run, ThrowsMessage<sim::FileError>(
                       AllOf(HasSubstr("none.json.gz: is not there"), HasSubstr("first lines"))));
}

/// What happened in every episode of a small run, as text. To write it again after a change that is
/// meant to change it: BULLETNAV_WRITE_GOLDEN=1 and run this test.
TEST_F(RunnerTest, GoldenRun) {
  const fs::path golden = fs::path(BULLETNAV_GOLDEN) / "run.txt";
  std::string text;
  for (const EpisodeResult& result :
       Play(Config("{agent: shortest_path}, {agent: random}, {agent: behaves}, "
                   "{agent: metric_map_fbe, models: {semantic_model: oracle}}, "
                   "{agent: nts, models: {semantic_model: oracle}}",
                   "conditions: [noise, no_stop]"),
            "golden")) {
    const GoalMetrics& goal = result.goals[0];
    text += fmt::format("{} {} {}: success {:d}, spl {:.3f}, {} steps, {} collisions, {:.3f} m\n",
                        result.key.agent, result.key.condition, result.key.episode, goal.success(),
                        goal.Value("spl"), goal.Whole("steps"), goal.Whole("collisions"),
                        goal.Value("path_length"));
  }
  if (std::getenv("BULLETNAV_WRITE_GOLDEN") != nullptr) sim::WriteFileAtomically(golden, text);
  EXPECT_EQ(text, sim::ReadTextFile(golden));
}

}  // namespace
}  // namespace bulletnav::bench
