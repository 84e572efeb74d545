// SPDX-License-Identifier: MIT
#include "benchmark/runs/merge_shards.h"

#include <chrono>
#include <cstdlib>
#include <map>
#include <thread>

#include <fmt/core.h>
#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include "agent/integer/quantised_file.h"
#include "agent/models/safetensors.h"
#include "benchmark/play/trajectory.h"
#include "benchmark/runs/agent_models.h"
#include "benchmark/runs/result_store.h"
#include "benchmark/runs/shard_record.h"
#include "sim/base/error.h"
#include "sim/base/files.h"
#include "sim/base/folder_lock.h"
#include "sim/config/yaml_writer.h"
#include "tests/support/houses.h"
#include "tests/support/killed.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

/// Runs in two bare houses that are split.
class MergeShardsTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    houses_ = new tests::TemporaryFolder;
    tests::WriteShellHouses(houses_->path(), 2, 2);
  }
  static void TearDownTestSuite() {
    delete houses_;
    houses_ = nullptr;
  }
  static RunConfig Config(const std::string& more = "") {
    const std::string folder = houses_->path().string();
    return ParseRunConfig(
        fmt::format("name: test\npanorama: {{rows: 16, cols: 64}}\nmax_steps: 60\n{}\nepisodes:\n"
                    "  file: {}/episodes.json\n  draw:\n    houses: {{index: {}/index.json}}\n"
                    "    counts: {{easy: 4, medium: 3}}\nagents: [{{agent: shortest_path}}, "
                    "{{agent: random}}]\n",
                    more, folder, folder),
        "test.yaml");
  }
  fs::path folder(const std::string& name) const { return temporary_.path() / name; }
  void Play(const std::string& name, std::optional<Shard> shard = {},
            std::optional<int> episodes = {}, const RunConfig& config = Config()) const {
    RunBenchmark(config, folder(name),
                 {.episodes = episodes, .workers = 2, .require_all = true, .shard = shard});
  }
  std::string Complaint(const std::string& name) const {
    try {
      MergeShards(folder(name));
    } catch (const sim::Error& e) {
      return e.what();
    }
    return "nothing";
  }
  /// All files but locks and shards, by name.
  std::map<std::string, std::string> Files(const std::string& name) const {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder(name))) {
      const std::string file = fs::relative(entry.path(), folder(name)).string();
      if (!entry.is_regular_file() || file.ends_with("lock") || file.starts_with("shards"))
        continue;
      files[file] = sim::ReadTextFile(entry.path());
    }
    return files;
  }
  /// Changes the record of a shard.
  void Spoil(const std::string& name, const Shard& shard,
             const std::function<void(ShardRecord*)>& change) const {
    const fs::path place = ShardFolder(folder(name), shard);
    ShardRecord record = ReadShardRecord(place);
    change(&record);
    sim::WriteFileAtomically(place / "shard.yaml", sim::ToYaml(record));
  }

 private:
  static tests::TemporaryFolder* houses_;
  tests::TemporaryFolder temporary_;
};

tests::TemporaryFolder* MergeShardsTest::houses_ = nullptr;

TEST_F(MergeShardsTest, MergedShardsAreOneRunByteForByte) {
  Play("whole");
  for (const int of : {1, 3, 20}) {
    const std::string name = std::to_string(of);
    for (int number = of; number >= 1; --number) Play(name, Shard{number, of});
    const RunOutcome outcome = MergeShards(folder(name));
    EXPECT_EQ(outcome.results.size(), 14u);
    EXPECT_EQ(outcome.folder, folder(name));
    EXPECT_EQ(Files(name), Files("whole")) << of;
    MergeShards(folder(name));
    EXPECT_EQ(Files(name), Files("whole")) << "merged again";
  }
  EXPECT_EQ(Files("whole").size(), 3u + 14u);
}

TEST_F(MergeShardsTest, AShardThatIsKilledGoesOnToTheSameBytes) {
  Play("whole");
  const int kills = tests::KillUntilDone(
      [&] {
        Play("killed", Shard{1, 2});
      },
      std::chrono::milliseconds(10),
      [](tests::Delay delay) {
        return delay + std::chrono::milliseconds(20);
      },
      [&] {
        EXPECT_THAT(Complaint("killed"), HasSubstr("--shard"));
      });
  EXPECT_GT(kills, 2);
  Play("killed", Shard{2, 2});
  MergeShards(folder("killed"));
  EXPECT_EQ(Files("killed"), Files("whole"));
}

TEST_F(MergeShardsTest, KilledWhileItMergesItCanBeRepeated) {
  Play("whole");
  const std::map<std::string, std::string> whole = Files("whole");
  for (const int number : {1, 2}) Play("run", Shard{number, 2});
  const int kills = tests::KillUntilDone(
      [&] {
        MergeShards(folder("run"));
      },
      tests::Delay(500),
      [](tests::Delay delay) {
        return delay + tests::Delay(500);
      },
      [&] {
        const std::map<std::string, std::string> files = Files("run");
        if (!files.contains("episodes.jsonl")) return;
        for (const auto& [file, text] : whole) EXPECT_EQ(files.at(file), text) << file;
      });
  EXPECT_GT(kills, 0);
  for (const auto& [file, text] : whole) EXPECT_EQ(Files("run").at(file), text) << file;
}

TEST_F(MergeShardsTest, TheFirstEpisodesCanBeSplitToo) {
  Play("whole", {}, 4);
  for (const int number : {1, 2}) Play("split", Shard{number, 2}, 4);
  MergeShards(folder("split"));
  EXPECT_EQ(Files("split"), Files("whole"));
}

TEST_F(MergeShardsTest, ACopyDoesNotTakeAnotherShardsPlace) {
  for (const int number : {1, 3}) Play("run", Shard{number, 3});
  fs::copy(ShardFolder(folder("run"), {1, 3}), ShardFolder(folder("run"), {2, 3}),
           fs::copy_options::recursive);
  EXPECT_THAT(Complaint("run"), AllOf(HasSubstr("2-of-3/shard.yaml"), HasSubstr("of shard 1/3"),
                                      HasSubstr("play shard 2/3")));
  EXPECT_FALSE(fs::exists(folder("run") / "episodes.jsonl"));
}

TEST_F(MergeShardsTest, NamesWhatIsMissing) {
  EXPECT_THAT(Complaint("run"), HasSubstr("holds no shards; play them with"));
  Play("run", Shard{2, 3});
  EXPECT_THAT(Complaint("run"), AllOf(HasSubstr("missing: 1/3, 3/3;"), HasSubstr("--shard 1/3")));
  Play("run", Shard{1, 3});
  Play("run", Shard{3, 3});
  const fs::path lines = ShardFolder(folder("run"), {2, 3}) / "episodes.jsonl";
  const std::string whole = sim::ReadTextFile(lines);
  sim::WriteFileAtomically(lines, whole.substr(whole.find('\n') + 1));
  const ResultKey gone = FromJsonLine(whole.substr(0, whole.find('\n')), "x", 1).key;
  EXPECT_THAT(Complaint("run"), AllOf(HasSubstr("2-of-3"), HasSubstr("lacks 1 of "),
                                      HasSubstr(gone.episode), HasSubstr("--shard 2/3")));
  EXPECT_FALSE(fs::exists(folder("run") / "episodes.jsonl"));
  sim::WriteFileAtomically(lines, whole);
  fs::remove(TrajectoryPath(lines.parent_path(), gone));
  EXPECT_THAT(Complaint("run"), HasSubstr(".json: is missing; play the shard again"));
  EXPECT_FALSE(fs::exists(folder("run") / "episodes.jsonl")) << "which comes last";
  EXPECT_THAT(
      [&] {
        Play("run");
      },
      testing::ThrowsMessage<sim::Error>(HasSubstr("holds shards of 3")));
}

TEST_F(MergeShardsTest, RefusesShardsThatAreNoPartsOfOneRun) {
  Play("run", Shard{1, 2});
  Play("run", Shard{2, 2});
  const auto complaint = [&](const std::function<void(ShardRecord*)>& change) {
    const ShardRecord good = ReadShardRecord(ShardFolder(folder("run"), {2, 2}));
    Spoil("run", {2, 2}, change);
    std::string text = Complaint("run");
    Spoil("run", {2, 2}, [&](ShardRecord* record) {
      *record = good;
    });
    return text;
  };
  EXPECT_THAT(complaint([](ShardRecord* record) {
                record->program = "0.0.1 (old)";
              }),
              AllOf(HasSubstr("2-of-2: is of another program (0.0.1 (old), not "),
                    HasSubstr("delete the folder")));
  EXPECT_THAT(complaint([](ShardRecord* record) {
                record->episodes = 4;
              }),
              HasSubstr("2-of-2: is of other episodes (the first 4, not all)"));
  EXPECT_THAT(complaint([](ShardRecord* record) {
                record->renderer = "egl, X1";
              }),
              HasSubstr("2-of-2: is of another renderer, whose pictures differ (egl, X1, not "));
  EXPECT_THAT(complaint([](ShardRecord* record) {
                record->processor = "AVX2";
              }),
              HasSubstr("2-of-2: is of another kind of processor"));
  Play("other", Shard{2, 2}, {}, Config("seeds: [5]"));
  fs::remove_all(ShardFolder(folder("run"), {2, 2}));
  fs::copy(ShardFolder(folder("other"), {2, 2}), ShardFolder(folder("run"), {2, 2}),
           fs::copy_options::recursive);
  EXPECT_THAT(Complaint("run"), AllOf(HasSubstr("2-of-2: is of another config than"),
                                      HasSubstr("1-of-2: line"), HasSubstr("delete the folder")));
}

TEST_F(MergeShardsTest, NamesWhichFilesAreOthers) {
  Play("run", Shard{1, 2});
  Play("run", Shard{2, 2});
  const fs::path file = ShardFolder(folder("run"), {2, 2}) / "config.yaml";
  const RunConfig config = LoadSavedRunConfig(file);
  const auto complaint = [&](const std::function<void(Fingerprints*)>& change) {
    RunConfig other = config;
    change(&other.fingerprints.value());
    sim::WriteFileAtomically(file, sim::ToYaml(other));
    return Complaint("run");
  };
  EXPECT_THAT(
      complaint([](Fingerprints* found) {
        found->scenes.begin()->second = "0123";
      }),
      AllOf(HasSubstr("2-of-2: is of other scenes than"), HasSubstr("house_000.glb; delete")));
  EXPECT_THAT(complaint([](Fingerprints* found) {
                found->episodes = "0123";
              }),
              HasSubstr("2-of-2: is of another file of episodes than"));
  EXPECT_THAT(
      complaint([](Fingerprints* found) {
        found->weights["nts_rgbd"] = "0123";
      }),
      AllOf(HasSubstr("2-of-2: is of other weights than"), HasSubstr(", as nts_rgbd; delete")));
  EXPECT_EQ(complaint([](Fingerprints* /*found*/) {}), "nothing");
}

TEST_F(MergeShardsTest, TheRendererIsTheOneThatIsTaken) {
  EXPECT_EQ(RendererName(sim::Backend::kEmbree), "embree");
  EXPECT_THAT(RendererName(sim::Backend::kAuto),
              testing::AnyOf(testing::Eq("embree"), testing::StartsWith("egl, ")));
  Play("run", Shard{1, 1});
  EXPECT_EQ(ReadShardRecord(ShardFolder(folder("run"), {1, 1})).renderer,
            RendererName(sim::Backend::kAuto));
}

TEST_F(MergeShardsTest, ShardsThatBeginAtOneTimeDrawTheEpisodesOnce) {
  Play("whole");
  RunConfig config = Config();
  const std::string drawn = config.episodes.file;
  const std::string kept = sim::ReadTextFile(drawn);
  fs::remove(drawn);
  std::vector<pid_t> children;
  for (const int number : {1, 2, 3}) {
    children.push_back(::fork());
    ASSERT_GE(children.back(), 0);
    if (children.back() != 0) continue;
    try {
      Play("run", Shard{number, 3});
    } catch (const sim::Error& e) {
      fmt::print(stderr, "shard {}: {}\n", number, e.what());
      std::_Exit(1);
    }
    std::_Exit(0);
  }
  for (const pid_t child : children) {
    int status = -1;
    ::waitpid(child, &status, 0);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
  }
  EXPECT_EQ(sim::ReadTextFile(drawn), kept);
  MergeShards(folder("run"));
  EXPECT_EQ(Files("run"), Files("whole"));
}

TEST_F(MergeShardsTest, WaitsForAnotherProcessThatDrawsTheEpisodes) {
  Play("whole");
  const fs::path drawn = Config().episodes.file;
  const std::string kept = sim::ReadTextFile(drawn);
  fs::remove(drawn);
  std::optional<sim::FolderLock> other(drawn.parent_path());
  std::vector<std::string> told;
  std::thread release;
  RunHooks hooks;
  hooks.prepare = [&](const std::string& what, int /*total*/) {
    told.push_back(what);
    if (what.starts_with("waiting") && !release.joinable()) {
      release = std::thread([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        sim::WriteFileAtomically(drawn, kept);
        other.reset();
      });
    }
    return [] {};
  };
  RunBenchmark(Config(), folder("run"), {.episodes = {}, .workers = 2}, hooks);
  release.join();
  EXPECT_THAT(told, testing::ElementsAre(HasSubstr("waiting for a process that draws"),
                                         HasSubstr("checking episodes")));
  EXPECT_EQ(Files("run"), Files("whole"));
}

TEST_F(MergeShardsTest, NetworksInFloatsAreOfOneKindOfProcessor) {
  const ShardRecord here = MakeShardRecord({1, 2}, {}, sim::Backend::kEmbree, "AVX2");
  ShardRecord there = MakeShardRecord({2, 2}, {}, sim::Backend::kEmbree, "AVX2");
  EXPECT_EQ(DifferenceOf(here, there), "");
  there.processor = "AVX1";
  EXPECT_THAT(DifferenceOf(here, there),
              AllOf(HasSubstr("another kind of processor"), HasSubstr("(AVX1, not AVX2)")));
}

TEST_F(MergeShardsTest, TheProcessorCountsWhereANetworkActsInFloats) {
  Play("run", Shard{1, 2});
  EXPECT_EQ(ReadShardRecord(ShardFolder(folder("run"), {1, 2})).processor, kAnyProcessor);

  // The shipped weights hold integers.
  RunConfig config = Config();
  config.agents.resize(1);
  config.agents[0].agent = "nts";
  EXPECT_FALSE(ActsInFloats(config));
  agent::TensorFile floats =
      agent::ReadTensorFile(FindWeights("assets/weights/nts_rgbd.safetensors"));
  std::erase_if(floats.tensors, [](const auto& entry) {
    return entry.first.starts_with(agent::kIntegerPrefix);
  });
  fs::create_directories(folder("weights"));
  const fs::path file = folder("weights") / "floats.safetensors";
  agent::WriteTensorFile(file, floats, agent::StoredType::kBfloat16);
  config.agents[0].models["semantic_model"] = file.string();
  EXPECT_TRUE(ActsInFloats(config));
}

TEST_F(MergeShardsTest, AFolderHasOneSplit) {
  const auto complaint = [&](std::optional<Shard> shard, std::optional<int> episodes = {}) {
    try {
      Play("run", shard, episodes);
    } catch (const sim::Error& e) {
      return std::string(e.what());
    }
    return std::string("nothing");
  };
  Play("run", Shard{1, 2});
  EXPECT_THAT(complaint(Shard{1, 3}), HasSubstr("is split into 2 shards, not 3; give --shard I/2"));
  EXPECT_THAT(complaint({}), AllOf(HasSubstr("holds shards of 2"), HasSubstr("bulletnav merge")));
  EXPECT_THAT(complaint(Shard{1, 2}, 4), HasSubstr("of other episodes (all, not the first 4)"));
  EXPECT_EQ(complaint(Shard{1, 2}), "nothing");
  Spoil("run", {1, 2}, [](ShardRecord* record) {
    record->program = "0.0.1 (old)";
  });
  EXPECT_THAT(complaint(Shard{1, 2}), HasSubstr("was begun as a shard of another program"));
}

}  // namespace
}  // namespace bulletnav::bench
