// SPDX-License-Identifier: MIT
#include "benchmark/runs/result_store.h"

#include <algorithm>
#include <csignal>
#include <limits>
#include <memory>
#include <thread>

#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "sim/base/error.h"
#include "sim/base/files.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::bench {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

constexpr const char* kConfig = "seed: 1\nagents: [random]\n";

EpisodeResult MakeResult(int i, std::size_t goals = 1) {
  EpisodeResult result;
  result.key = {"random", "rgbd", "noise", 3, "house_001.glb", std::to_string(i)};
  result.difficulty = Difficulty::kHard;
  for (std::size_t k = 0; k < goals; ++k) {
    GoalMetrics metrics;
    metrics["success"] = i % 2 == 0;
    metrics["spl"] = 0.1 / (i + 1);
    metrics["soft_spl"] = 1.0 / 3.0;
    metrics["start_distance"] = 7.125;
    metrics["distance_to_goal"] = i % 3 == 0 ? std::numeric_limits<double>::infinity() : 1e-17;
    metrics["euclidean_distance"] = 4;
    metrics["path_length"] = 12.3;
    metrics["steps"] = 500;
    metrics["collisions"] = static_cast<int>(k);
    result.goals.push_back(metrics);
  }
  return result;
}

class ResultStoreTest : public testing::Test {
 protected:
  std::filesystem::path folder() const { return temporary_.path() / "run"; }
  std::filesystem::path lines() const { return folder() / "episodes.jsonl"; }
  std::string Complaint(const std::string& config = kConfig) const {
    try {
      const ResultStore store(folder(), config);
    } catch (const sim::Error& e) {
      EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos);
      return e.what();
    }
    return "nothing";
  }
  void Fill(int count) const {
    ResultStore store(folder(), kConfig);
    for (int i = 0; i < count; ++i)
      store.Append(MakeResult(i, 1 + static_cast<std::size_t>(i) % 3));
  }

 private:
  tests::TemporaryFolder temporary_;
};

TEST(EpisodeResult, LineComesBackBitForBit) {
  for (int i = 0; i < 6; ++i) {
    EpisodeResult result = MakeResult(i, i < 3 ? 1 : 4);
    if (i == 2) result.failure = "threw \"no map\"\nat step 3";
    if (i == 4) result.difficulty.reset();
    const std::string line = ToJsonLine(result);
    EXPECT_EQ(line.find('\n'), std::string::npos);
    EXPECT_EQ(FromJsonLine(line, "x", 1), result);
    EXPECT_EQ(ToJsonLine(FromJsonLine(line, "x", 1)), line);
  }
}

TEST(EpisodeResult, DamagedLinesAreNamed) {
  const std::string line = ToJsonLine(MakeResult(0, 1));
  try {
    FromJsonLine("{?" + line.substr(1), "x.jsonl", 12);
    FAIL() << "read";
  } catch (const sim::FileError& e) {
    EXPECT_THAT(e.what(), StartsWith("x.jsonl:12:2: not valid JSON"));
  }
}

TEST(EpisodeResult, SurvivesTextThatIsNoUtf8) {
  EpisodeResult result = MakeResult(0);
  result.failure = "bad \xff byte";
  EXPECT_THAT(FromJsonLine(ToJsonLine(result), "x", 1).failure, HasSubstr("bad"));
}

TEST_F(ResultStoreTest, GoesOnWhereItStopped) {
  Fill(5);
  ResultStore store(folder(), kConfig);
  EXPECT_EQ(store.size(), 5u);
  for (int i = 0; i < 5; ++i) EXPECT_TRUE(store.Has(MakeResult(i).key));
  EXPECT_FALSE(store.Has(MakeResult(5).key));
  ResultKey other = MakeResult(0).key;
  other.condition = "no_noise";
  EXPECT_FALSE(store.Has(other));
  store.Append(MakeResult(5));
  EXPECT_EQ(ReadResults(folder()), store.results());
  EXPECT_EQ(sim::ReadTextFile(folder() / "config.yaml"), kConfig);
}

TEST_F(ResultStoreTest, DropsTheLineThatWasBeingWritten) {
  Fill(3);
  const std::string whole = sim::ReadTextFile(lines());
  const std::size_t last = whole.rfind('\n', whole.size() - 2) + 1;
  for (std::size_t size = last; size < whole.size(); ++size) {
    sim::WriteFileAtomically(lines(), std::string_view(whole).substr(0, size));
    EXPECT_EQ(ReadResults(folder()).size(), 2u);
    ResultStore store(folder(), kConfig);
    EXPECT_EQ(store.size(), 2u);
    store.Append(MakeResult(2, 3));
    EXPECT_EQ(sim::ReadTextFile(lines()), whole) << size;
  }
}

/// A child appends as fast as it can until it is killed; whatever it was doing, what is found is a
/// first part of what it wrote, and the rest can follow.
TEST_F(ResultStoreTest, SurvivesBeingKilledAtAnyMoment) {
  constexpr int kResults = 400;
  for (int round = 0; round < 5; ++round) {
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      ResultStore store(folder(), kConfig);
      for (int i = 0; i < kResults; ++i) {
        if (!store.Has(MakeResult(i).key)) store.Append(MakeResult(i));
      }
      ::pause();
    }
    ::usleep(static_cast<useconds_t>(4000 + 7000 * round));
    ::kill(child, SIGKILL);
    int status = 0;
    ::waitpid(child, &status, 0);
    const std::size_t found = ResultStore(folder(), kConfig).size();
    for (std::size_t i = 0; i < found; ++i) {
      EXPECT_TRUE(ResultStore(folder(), kConfig).Has(MakeResult(static_cast<int>(i)).key));
      i += found / 8;  // a sample
    }
  }
  ResultStore store(folder(), kConfig);
  std::string expected;
  for (int i = 0; i < kResults; ++i) {
    if (!store.Has(MakeResult(i).key)) store.Append(MakeResult(i));
    expected += ToJsonLine(MakeResult(i)) + "\n";
  }
  EXPECT_EQ(sim::ReadTextFile(lines()), expected);
}

TEST_F(ResultStoreTest, RefusesASecondRunUntilTheFirstIsOver) {
  auto first = std::make_unique<ResultStore>(folder(), kConfig);
  EXPECT_THAT(Complaint(), AllOf(HasSubstr("another run (process " + std::to_string(::getpid())),
                                 HasSubstr("--shard I/N"), HasSubstr("another --out")));
  first.reset();
  EXPECT_EQ(Complaint(), "nothing");
}

TEST_F(ResultStoreTest, RefusesResultsOfAnotherConfig) {
  Fill(2);
  EXPECT_THAT(Complaint("seed: 2\nagents: [random]\n"),
              AllOf(HasSubstr("another config"),
                    HasSubstr("line 1 is 'seed: 1' there and 'seed: 2'"), HasSubstr("--out")));
  EXPECT_THAT(Complaint(std::string(kConfig) + "more: 1\n"), HasSubstr("line 3 is '' there"));
  EXPECT_EQ(sim::ReadTextFile(folder() / "config.yaml"), kConfig);
  EXPECT_EQ(ReadResults(folder()).size(), 2u);
  std::filesystem::remove(folder() / "config.yaml");
  EXPECT_THAT(Complaint(), HasSubstr("no config.yaml"));
}

TEST_F(ResultStoreTest, GoesOnWithAnotherConfigThatItIsToldHolds) {
  Fill(2);
  const auto open = [&](bool holds) {
    const ResultStore store(folder(), "seed: 2\n", [&](const std::string& other) {
      EXPECT_EQ(other, kConfig);
      return holds;
    });
    return store.size();
  };
  EXPECT_THROW(open(false), sim::Error);
  EXPECT_EQ(sim::ReadTextFile(folder() / "config.yaml"), kConfig);
  EXPECT_EQ(open(true), 2u);
  EXPECT_EQ(sim::ReadTextFile(folder() / "config.yaml"), "seed: 2\n");
}

/// The file may not grow beyond a limit: a write first comes short, then fails, as on a full disk.
TEST_F(ResultStoreTest, FullDiskLosesNothing) {
  ResultStore store(folder(), kConfig);
  store.Append(MakeResult(0));
  const std::string before = sim::ReadTextFile(lines());
  rlimit old = {};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &old), 0);
  rlimit tight = old;
  tight.rlim_cur = before.size() + 10;
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &tight), 0);
  std::string complaint;
  try {
    store.Append(MakeResult(1));
  } catch (const sim::FileError& e) {
    complaint = e.what();
  }
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &old), 0);
  std::signal(SIGXFSZ, old_handler);
  EXPECT_THAT(complaint, AllOf(HasSubstr("episodes.jsonl"), HasSubstr("the 1 finished"),
                               HasSubstr("free some space and run the same command again")));
  EXPECT_EQ(sim::ReadTextFile(lines()), before);
  EXPECT_FALSE(store.Has(MakeResult(1).key));
  store.Append(MakeResult(1));
  EXPECT_EQ(ReadResults(folder()).size(), 2u);
}

TEST_F(ResultStoreTest, NamesTheLineThatIsDamaged) {
  Fill(3);
  const std::string text = sim::ReadTextFile(lines());
  std::string bad = text;
  bad[text.find('\n') + 20] = '{';
  sim::WriteFileAtomically(lines(), bad);
  EXPECT_THAT(Complaint(), HasSubstr("episodes.jsonl:2"));
  sim::WriteFileAtomically(lines(), text + "{\"agent\": \"x\"}\n");
  EXPECT_THAT(Complaint(), AllOf(HasSubstr("episodes.jsonl:4"), HasSubstr("'setting' is missing")));
  sim::WriteFileAtomically(lines(), text + text);
  EXPECT_THAT(Complaint(), AllOf(HasSubstr("episodes.jsonl:4"), HasSubstr("a second time")));
}

TEST_F(ResultStoreTest, WhatCanBeReadIsReadAndTheRestIsNamed) {
  Fill(3);
  const std::string text = sim::ReadTextFile(lines());
  EXPECT_EQ(ReadReadableResults(folder()).results.size(), 3u);
  EXPECT_TRUE(ReadReadableResults(folder()).damaged.empty());
  sim::WriteFileAtomically(lines(),
                           "garbage{\n" + text + text + std::string(99, '[') + "\n{\"agent\": ");
  const ReadableResults readable = ReadReadableResults(folder());
  EXPECT_EQ(readable.results.size(), 3u);
  EXPECT_THAT(
      readable.damaged,
      testing::ElementsAre(HasSubstr("jsonl:1:"), HasSubstr("jsonl:5: "), HasSubstr("jsonl:6: "),
                           HasSubstr("jsonl:7: "), HasSubstr("jsonl:8: "),
                           AllOf(HasSubstr("jsonl:9: "), HasSubstr("cut off"))));
  EXPECT_THROW(ReadResults(folder()), sim::FileError);
}

TEST_F(ResultStoreTest, ThreadsMayAppendTogether) {
  {
    ResultStore store(folder(), kConfig);
    std::vector<std::thread> threads;
    for (int t = 0; t < 4; ++t) {
      threads.emplace_back([&store, t] {
        for (int i = t; i < 40; i += 4) store.Append(MakeResult(i));
      });
    }
    for (std::thread& thread : threads) thread.join();
  }
  const auto results = ReadResults(folder());
  EXPECT_EQ(results.size(), 40u);
  EXPECT_TRUE(std::is_sorted(results.begin(), results.end(), [](const auto& a, const auto& b) {
    return a.key < b.key;
  }));
}

TEST_F(ResultStoreTest, NeedsResultsToRead) {
  EXPECT_THROW(ReadResults(folder()), sim::FileError);
}

TEST_F(ResultStoreTest, PutsLinesInOrderAndGoesOn) {
  ResultStore store(folder(), kConfig);
  std::map<ResultKey, std::string> sorted;
  for (const int i : {4, 1, 3, 0}) {
    store.Append(MakeResult(i));
    sorted[MakeResult(i).key] = ToJsonLine(MakeResult(i));
  }
  store.PutInOrder();
  std::string expected;
  for (const auto& [key, line] : sorted) expected += line + "\n";
  EXPECT_EQ(sim::ReadTextFile(lines()), expected);
  EXPECT_EQ(ReadResultLines(folder()), sorted);
  store.Append(MakeResult(2));
  EXPECT_EQ(sim::ReadTextFile(lines()), expected + ToJsonLine(MakeResult(2)) + "\n");
}

TEST_F(ResultStoreTest, AddsResultsOfOthersButNoneThatDiffer) {
  ResultStore store(folder(), kConfig);
  store.Append(MakeResult(1));
  ResultLines others;
  for (const int i : {0, 1, 2}) others[MakeResult(i).key] = ToJsonLine(MakeResult(i));
  store.Add(others);
  EXPECT_EQ(store.size(), 3u);
  EXPECT_EQ(ReadResultLines(folder()), others);
  EpisodeResult other = MakeResult(2);
  other.failure = "threw: lost";
  try {
    store.Add({{other.key, ToJsonLine(other)}});
    FAIL() << "added";
  } catch (const sim::FileError& e) {
    EXPECT_THAT(e.what(), HasSubstr("holds another result of episode '" + other.key.episode));
  }
  EXPECT_EQ(ReadResultLines(folder()), others);
}

TEST_F(ResultStoreTest, AddsWhatWasPlayedAgainInPlaceOfFailures) {
  ResultStore store(folder(), kConfig);
  EpisodeResult failed = MakeResult(2);
  failed.failure = "threw: lost";
  store.Append(failed);
  const std::string line = ToJsonLine(MakeResult(2));
  store.Add({{failed.key, line}});
  EXPECT_EQ(sim::ReadTextFile(lines()), line + "\n");
  EXPECT_EQ(store.results(), std::vector{MakeResult(2)});
}

TEST_F(ResultStoreTest, MakesItsFileWithTheFirstResultOrAllAtOnce) {
  ResultStore store(folder(), kConfig);
  EXPECT_FALSE(std::filesystem::exists(lines()));
  EXPECT_TRUE(ReadResults(folder()).empty()) << "of a run that has begun";
  EXPECT_EQ(store.ForgetFailed(), 0);
  store.PutInOrder();
  EXPECT_TRUE(std::filesystem::exists(lines()));
  store.Append(MakeResult(1));
  EXPECT_EQ(ReadResults(folder()).size(), 1u);
}

TEST_F(ResultStoreTest, ForgetsFailedEpisodesAndGoesOn) {
  ResultStore store(folder(), kConfig);
  for (int i = 0; i < 6; ++i) {
    EpisodeResult result = MakeResult(i);
    if (i % 2 == 1) result.failure = "threw: lost";
    store.Append(result);
  }
  EXPECT_EQ(store.ForgetFailed(), 3);
  EXPECT_EQ(store.ForgetFailed(), 0);
  EXPECT_EQ(store.size(), 3u);
  EXPECT_FALSE(store.Has(MakeResult(1).key));
  store.Append(MakeResult(1));
  EXPECT_EQ(ReadResults(folder()), store.results());
  EXPECT_EQ(store.size(), 4u);
}

}  // namespace
}  // namespace bulletnav::bench
