// SPDX-License-Identifier: MIT
// Runs the program itself, as its users do.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <gmock/gmock.h>
#include <sys/wait.h>

#include "sim/base/files.h"
#include "sim/scene/glb_writer.h"
#include "tests/support/scenes.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

constexpr int kBadUse = 2;
constexpr int kFailed = 1;

struct Outcome {
  int status = -1;
  std::string out;
  std::string err;
};

std::string TextOf(const Outcome& outcome) {
  return fmt::format("status {}\n{}{}", outcome.status, outcome.out, outcome.err);
}

/// Calls in one folder, with paths relative to it.
class CommandsTest : public testing::Test {
 protected:
  /// `variables`: as "NAME=value ...", in the environment.
  Outcome Run(const std::string& arguments, const std::string& variables = "") const {
    const std::string command = fmt::format(
        "cd '{}' && env -u SLURM_ARRAY_TASK_ID {} '{}' {} >out.txt 2>err.txt </dev/null",
        folder_.path().string(), variables, BULLETNAV_PROGRAM, arguments);
    const int status = std::system(command.c_str());
    Outcome outcome;
    if (WIFEXITED(status)) outcome.status = WEXITSTATUS(status);
    outcome.out = Read("out.txt");
    outcome.err = Read("err.txt");
    return outcome;
  }
  /// What a call that is to succeed prints.
  std::string Output(const std::string& arguments, const std::string& variables = "") const {
    const Outcome outcome = Run(arguments, variables);
    EXPECT_EQ(outcome.status, 0) << arguments << '\n' << TextOf(outcome);
    return outcome.out;
  }
  /// Expects one line on standard error, and nothing else.
  void ExpectError(const std::string& arguments, int status, const std::string& text) const {
    const Outcome outcome = Run(arguments);
    EXPECT_EQ(outcome.status, status) << arguments;
    EXPECT_EQ(outcome.out, "") << arguments;
    EXPECT_THAT(outcome.err,
                AllOf(StartsWith("bulletnav: error: "), HasSubstr(text), EndsWith("\n")))
        << arguments;
    EXPECT_EQ(outcome.err.find('\n') + 1, outcome.err.size()) << outcome.err;
  }
  std::string Read(const fs::path& file) const { return sim::ReadTextFile(folder_.path() / file); }
  bool Has(const fs::path& file) const { return fs::exists(folder_.path() / file); }
  void Write(const std::string& name, const std::string& text) const { folder_.Write(name, text); }
  /// corridor.glb, and run.yaml: a few easy episodes in it.
  void WriteExperiment() const {
    sim::WriteFileAtomically(folder_.path() / "corridor.glb",
                             sim::EncodeGlb(tests::LCorridor(7.0f, 7.0f, 2.0f, 2.5f)));
    Write("run.yaml",
          "panorama: {rows: 16, cols: 64}\nmax_steps: 60\nbackend: embree\n"
          "episodes:\n  file: episodes.json\n"
          "  draw: {scenes: [corridor.glb], counts: {easy: 4}, seed: 3}\n"
          "agents: [{agent: shortest_path}, {agent: random}]\n");
  }
  int CountFiles(const std::string& folder, const std::string& extension) const {
    int count = 0;
    for (const auto& entry : fs::recursive_directory_iterator(folder_.path() / folder)) {
      if (entry.path().extension() == extension) ++count;
    }
    return count;
  }

 private:
  tests::TemporaryFolder folder_;
};

/// The names in the list of commands that --help ends with.
std::vector<std::string> CommandsIn(const std::string& help) {
  std::vector<std::string> commands;
  std::istringstream lines(help.substr(help.find("Subcommands:\n")));
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    // Descriptions that go on in a further line are indented more.
    if (line.size() > 2 && line[2] != ' ')
      commands.push_back(line.substr(2, line.find(' ', 2) - 2));
  }
  return commands;
}

TEST_F(CommandsTest, EveryCommandExplainsItself) {
  const std::vector<std::string> commands = CommandsIn(Output("--help"));
  for (const char* known : {"scenes", "render", "episodes", "dataset", "train", "run", "merge",
                            "table", "compare", "plot", "bench", "evaluate-perception"}) {
    EXPECT_THAT(commands, testing::Contains(known));
  }
  for (const std::string& command : commands) {
    const std::string help = Output(command + " --help");
    EXPECT_THAT(help, AllOf(HasSubstr("Usage: bulletnav " + command), HasSubstr("--help")));
    if (help.find("Subcommands:\n") == std::string::npos) continue;
    for (const std::string& inner : CommandsIn(help)) {
      const std::string whole = command + " " + inner;
      EXPECT_THAT(Output(whole + " --help"), HasSubstr("Usage: bulletnav " + whole));
    }
  }
}

TEST_F(CommandsTest, TellsItsVersion) {
  EXPECT_THAT(Output("--version"), testing::MatchesRegex("bulletnav [0-9]+\\.[0-9]+\\.[0-9]+.*\n"));
}

TEST_F(CommandsTest, BadUseIsOneLineAndStatusTwo) {
  Write("run.yaml", "");
  ExpectError("", kBadUse, "A subcommand is required");
  ExpectError("rum", kBadUse, "there is no command 'rum'; see --help");
  ExpectError("--bogus", kBadUse, "there is no option '--bogus'; see --help");
  ExpectError("run", kBadUse, "config is required; see --help");
  ExpectError("run run.yaml --bogus", kBadUse, "--bogus; see --help");
  ExpectError("run run.yaml --workers many", kBadUse, "--workers");
  ExpectError("run run.yaml --episodes 0", kBadUse, "--episodes");
  ExpectError("run run.yaml --shard 4/3", kBadUse, "'4/3' is no shard; give I/N");
  ExpectError("plot x --worst 2 --all", kBadUse, "--all");
  ExpectError("compare one_folder", kBadUse, "second is required");
  ExpectError("run --bogus", kBadUse, "there is no option '--bogus'; see --help");
  ExpectError("scenes polish", kBadUse, "there is no command 'polish'; see --help");
  ExpectError("render x.glb", kBadUse, "--out is required");
  ExpectError("bench --only nothing", kBadUse, "--only");
}

TEST_F(CommandsTest, BadInputIsOneLineThatNamesThePlaceAndStatusOne) {
  WriteExperiment();
  for (const char* command : {"run", "episodes generate", "dataset", "train"}) {
    ExpectError(std::string(command) + " none.yaml", kFailed, "none.yaml: ");
  }
  ExpectError("scenes inspect none.glb", kFailed, "none.glb: ");
  ExpectError("render none.glb --out pictures", kFailed, "none.glb: ");
  ExpectError("episodes show none.json", kFailed, "none.json: ");
  for (const char* command : {"table", "plot", "merge"}) {
    ExpectError(std::string(command) + " nowhere", kFailed, "nowhere");
  }
  ExpectError("compare nowhere neither", kFailed, "nowhere");
  Write("typo.yaml", "episodes:\n  file: episodes.json\n  fil: x\nagents: [{agent: random}]\n");
  ExpectError("run typo.yaml", kFailed, "typo.yaml:3:3: unknown key 'fil'");
  Write("open.yaml", "episodes: {file: episodes.json\nagents: [");
  ExpectError("run open.yaml", kFailed, "open.yaml:");
  Write("agent.yaml", "episodes: {file: episodes.json}\nagents:\n  - {agent: randum}\n");
  ExpectError("run agent.yaml", kFailed, "agent.yaml:3:");
  Write("text.glb", "no mesh");
  ExpectError("scenes inspect text.glb", kFailed, "text.glb: ");
  Write("cut.json", "{\"episodes\": [");
  ExpectError("episodes show cut.json", kFailed, "cut.json:1");
  ExpectError("run run.yaml --out run.yaml", kFailed, "run.yaml");
  EXPECT_FALSE(Has("results"));
}

TEST_F(CommandsTest, WeightsAreToldAndStripped) {
  const std::string shipped = "assets/weights/place_rgb.safetensors";
  EXPECT_THAT(Output("weights " + shipped),
              AllOf(HasSubstr("in integers"), HasSubstr("\ntask              place\n")));
  EXPECT_THAT(Output("weights " + shipped + " --integers-only alone.safetensors"),
              HasSubstr("integers_alone    true"));
  EXPECT_TRUE(Has("alone.safetensors"));
  ExpectError("weights none.safetensors", kFailed, "none.safetensors: ");
  Write("text.safetensors", "no weights at all");
  ExpectError("weights text.safetensors", kFailed, "text.safetensors: ");
}

TEST_F(CommandsTest, ScenesAreGeneratedInspectedAndDrawn) {
  WriteExperiment();
  EXPECT_THAT(Output("scenes inspect corridor.glb --topdown plan.png"), HasSubstr("walkable"));
  const std::string instance = Output("scenes export corridor.glb --format scene_instance --out s");
  EXPECT_EQ(instance, "s/scenes/corridor.scene_instance.json\n");
  EXPECT_THAT(Output("scenes inspect s/scenes/corridor.scene_instance.json"),
              HasSubstr("walkable"));
  EXPECT_EQ(Output("scenes export corridor.glb --format sdf --out s"), "s/corridor.sdf\n");
  // What lies beside a mesh need not be its description, unless doors are to be turned.
  Write("corridor.json", "{}");
  const Outcome outcome = Run("scenes export corridor.glb --format sdf --out s");
  EXPECT_EQ(outcome.out, "s/corridor.sdf\n");
  EXPECT_THAT(outcome.err, HasSubstr("warning: doors are exported without hinges: corridor.glb"));
  ExpectError("scenes export corridor.glb --format sdf --out s --doors closed", kFailed,
              "corridor.json");
  Write("corridor.json", "{\"openings\": []}");
  EXPECT_EQ(Run("scenes export corridor.glb --format sdf --out s").err, "");
  EXPECT_THAT(Output("scenes inspect corridor.glb --json"), StartsWith("{"));
  EXPECT_TRUE(Has("plan.png"));
  Output("render corridor.glb --random 2 --seed 5 --size 64x16 --backend embree --out pictures");
  EXPECT_EQ(CountFiles("pictures", ".png"), 4);
  Output(
      "render corridor.glb --pose 1,0,-1,90 --projection pinhole --size 32x24 --backend embree "
      "--out flat");
  EXPECT_EQ(CountFiles("flat", ".png"), 2);
  Output(
      "render corridor.glb --pose 1,0,-1,90 --projection pinhole --size 32x24 --backend embree "
      "--sensor-noise depth_camera --out noisy");
  EXPECT_NE(Read("noisy/0000_depth.png"), Read("flat/0000_depth.png"));
  Output("scenes generate --count 1 --seed 4 --out houses");
  EXPECT_TRUE(Has("houses/house_000.glb"));
  EXPECT_TRUE(Has("houses/index.json"));
}

TEST_F(CommandsTest, EpisodesAreDrawnConvertedAndShown) {
  WriteExperiment();
  Write("episodes.yaml", "scenes: [corridor.glb]\ncounts: {easy: 3, medium: 1}\nout: e.json\n");
  Output("episodes generate episodes.yaml");
  EXPECT_THAT(Output("episodes show e.json"), HasSubstr("4 episodes"));
  Output("episodes export e.json --format list --out list.json.gz");
  EXPECT_THAT(Output("episodes show list.json.gz"), HasSubstr("4 episodes"));
  const std::string drawn = Read("e.json");
  Output("episodes generate episodes.yaml --workers 2 --out again.json");
  EXPECT_EQ(Read("again.json"), drawn);
}

TEST_F(CommandsTest, ARunIsPlayedTabledComparedAndDrawn) {
  WriteExperiment();
  EXPECT_THAT(Output("run run.yaml --no-plots"), HasSubstr("results: results/run\n"));
  const std::string lines = Read("results/run/episodes.jsonl");
  EXPECT_EQ(std::count(lines.begin(), lines.end(), '\n'), 8);
  EXPECT_FALSE(Has("results/run/plots"));
  const Outcome again = Run("run run.yaml --no-plots");
  EXPECT_EQ(again.status, 0);
  EXPECT_THAT(again.err, HasSubstr("going on after 8 of 8 episodes"));
  EXPECT_EQ(Read("results/run/episodes.jsonl"), lines);
  const std::string table = Read("results/run/table.md");
  Write("results/run/table.md", "");
  Output("table results/run");
  EXPECT_EQ(Read("results/run/table.md"), table);
  EXPECT_THAT(Output("compare results/run results/run --agents shortest_path random"),
              HasSubstr("shortest_path"));
  EXPECT_THAT(Output("compare results/run results/run --against random --markdown"),
              HasSubstr("| random -> shortest_path |"));
  EXPECT_THAT(Output("plot results/run --worst 1"), HasSubstr("results/run/plots"));
  EXPECT_GE(CountFiles("results/run/plots", ".svg"), 1);
}

TEST_F(CommandsTest, ShardsOfASlurmArrayAreMergedIntoOneRun) {
  WriteExperiment();
  Output("run run.yaml --no-plots --out whole");
  const Outcome first = Run("run run.yaml --out parts",
                            "SLURM_ARRAY_TASK_ID=0 SLURM_ARRAY_TASK_MIN=0 "
                            "SLURM_ARRAY_TASK_COUNT=2");
  EXPECT_EQ(first.status, 0) << TextOf(first);
  EXPECT_THAT(first.err, HasSubstr("note: --shard 1/2, from SLURM_ARRAY_TASK_ID"));
  EXPECT_THAT(first.out, HasSubstr("when all 2 shards are done: ./bulletnav merge parts"));
  ExpectError("merge parts", kFailed, "these shards are missing: 2/2");
  ExpectError("run run.yaml --out parts", kFailed, "holds shards of 2");
  ExpectError("run run.yaml --shard 1/3 --out parts", kFailed, "is split into 2 shards, not 3");
  Output("run run.yaml --shard 2/2 --out parts");
  EXPECT_THAT(Output("merge parts"), HasSubstr("results: parts\n"));
  for (const char* file :
       {"config.yaml", "episodes.jsonl", "summary.json", "table.md", "versions.txt"}) {
    EXPECT_EQ(Read(fs::path("parts") / file), Read(fs::path("whole") / file)) << file;
  }
  EXPECT_EQ(CountFiles("parts/trajectories", ".json"), 8);
}

/// All are read before the first begins, and what is done is not done again.
TEST_F(CommandsTest, TrainsOneConfigAfterTheOther) {
  for (const char* name : {"first", "second", "twin"}) {
    const std::string out = name == std::string("twin") ? "first" : name;
    Write(name + std::string(".yaml"),
          "task: four_rooms\nout: " + out +
              "\nppo: {lanes: 4, rollout: 8, epochs: 1, minibatches: 1}\nmodel: {width: 16}\n"
              "steps: 2\nvalidate_every: 1\n");
  }
  ExpectError("train first.yaml none.yaml", kFailed, "none.yaml: ");
  ExpectError("train first.yaml twin.yaml", kFailed, "twin.yaml: trains into first, as first.yaml");
  EXPECT_FALSE(Has("first"));
  Output("train first.yaml second.yaml steps=1");
  EXPECT_TRUE(Has("first/weights.safetensors"));
  const std::string weights = Read("second/weights.safetensors");
  EXPECT_THAT(Output("train first.yaml second.yaml steps=1"),
              HasSubstr("weights and curves: first\nweights and curves: second\n"));
  EXPECT_EQ(Read("second/weights.safetensors"), weights);
}

/// One processor plays the parts of others: what is made, drawn, seen, answered and decided is the
/// same to the bit, with and without fused multiply-add in the C library, for any number of workers
/// and lanes, and after a kill.
TEST_F(CommandsTest, HousesAndEpisodesAreTheSameOnEveryInstructionSet) {
  struct Machine {
    std::string name;
    std::string variables;
    int workers;
    int lanes;
  };
  const std::vector<Machine> machines = {
      {"widest", "", 1, 1},
      {"sse41", "BULLETNAV_ISA=sse41 GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2,-FMA", 2, 3},
      {"avx2", "BULLETNAV_ISA=avx2", 1, 8}};
  std::vector<std::string> houses;
  std::vector<std::string> episodes;
  for (const Machine& machine : machines) {
    Output("scenes generate --count 1 --out houses", machine.variables);
    houses.push_back(Read("houses/house_000.glb"));
    Write(
        machine.name + ".yaml",
        fmt::format("max_steps: 30\nbackend: embree\ntrajectories: false\nepisodes:\n"
                    "  file: episodes.json\n"
                    "  draw: {{scenes: [houses/house_000.glb], sequential_goals: 2, seed: 3,\n"
                    "         counts: {{easy: 1, medium: 1, sequential: 1}}}}\n"
                    "settings: [rgb, rgbd]\n"
                    "agents: [{{agent: nts, lanes: {0}}}, {{agent: metric_map_fbe, lanes: {0}}}]\n",
                    machine.lanes));
    const std::string run = fmt::format("run {0}.yaml --workers {1} --no-plots --out {0}",
                                        machine.name, machine.workers);
    if (machine.name == "avx2") Run(run, machine.variables + " timeout -s KILL 3");
    Output(run, machine.variables);
    episodes.push_back(Read(fs::path(machine.name) / "episodes.jsonl"));
  }
  EXPECT_EQ(std::count(episodes[0].begin(), episodes[0].end(), '\n'), 2 * 2 * 3);
  for (std::size_t i = 1; i < machines.size(); ++i) {
    EXPECT_TRUE(houses[i] == houses[0]) << machines[i].name;
    EXPECT_EQ(episodes[i], episodes[0]) << machines[i].name;
  }
}

/// OpenCV's, OpenBLAS' and our own kernels for AVX-512 must not show: AVX2 is what all have.
TEST_F(CommandsTest, SlamRunsAreTheSameOnEveryProcessorWithAvx2) {
  if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma")) GTEST_SKIP();
  Output("scenes generate --count 1 --out houses");
  Write("slam.yaml",
        "scenes: [houses/house_000.glb]\nactions: [500]\n"
        "vocabulary: {houses: {folder: houses, count: 1}, actions: 100}\n"
        "detectors: [{detector: bow}]\n");
  Output("slam run slam.yaml --out widest");
  Output("slam run slam.yaml --out avx2",
         "BULLETNAV_ISA=avx2 OPENCV_CPU_DISABLE=AVX512-SKX "
         "GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX512F,-AVX512VL,-AVX512BW");
  const std::string result = Read("widest/drives/house_000_500_0/result.yaml");
  EXPECT_EQ(Read("avx2/drives/house_000_500_0/result.yaml"), result);
  EXPECT_THAT(result, Not(HasSubstr("accepted: 0")));
}

}  // namespace
}  // namespace bulletnav::bench
