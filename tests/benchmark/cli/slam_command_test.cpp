// SPDX-License-Identifier: MIT
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "benchmark/cli/commands.h"
#include "benchmark/cli/program.h"
#include "benchmark/slam/io/g2o.h"
#include "benchmark/slam/io/tum.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::bench {
namespace {

using ::testing::HasSubstr;

/// Out along a street and back, with a last step that is measured 0.3 m short, and a loop.
constexpr const char* kGraph =
    "VERTEX_SE2 0 0 0 0\n"
    "VERTEX_SE2 1 1 0 0\n"
    "VERTEX_SE2 2 1.7 0 0\n"
    "EDGE_SE2 0 1 1 0 0 1 0 0 1 0 1\n"
    "EDGE_SE2 1 2 0.7 0 0 1 0 0 1 0 1\n"
    "EDGE_SE2 0 2 2 0 0 1 0 0 1 0 1\n";

struct Ran {
  int status = 0;
  std::string out;
  std::string err;
};

Ran RunSlam(std::vector<std::string> words) {
  words.insert(words.begin(), {"bulletnav", "slam"});
  std::vector<char*> argv;
  argv.reserve(words.size());
  for (std::string& word : words) argv.push_back(word.data());
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  const int status = RunProgram(static_cast<int>(argv.size()), argv.data(), AddSlamCommand);
  return {status, testing::internal::GetCapturedStdout(), testing::internal::GetCapturedStderr()};
}

TEST(SlamOptimize, WritesTheOptimisedGraphAndReports) {
  const tests::TemporaryFolder folder;
  const std::string in = folder.Write("in.g2o", kGraph).string();
  const std::filesystem::path out = folder.path() / "out.g2o";
  const Ran ran = RunSlam({"optimize", in, "--out", out.string()});
  EXPECT_EQ(ran.status, 0) << ran.err;
  // An error of 0.3 m over three edges alike: 0.1 m each.
  EXPECT_THAT(ran.out, HasSubstr("| 3 | 3 | 1 | 0.045 | 0.015 |"));
  const auto graph = std::get<agent::PlanarPoseGraph>(ReadG2o(out));
  EXPECT_NEAR(graph.vertices[1].pose.x, 1.1, 1e-6);
  EXPECT_NEAR(graph.vertices[2].pose.x, 1.9, 1e-6);
}

TEST(SlamOptimize, KernelsTrustLoopsLess) {
  const tests::TemporaryFolder folder;
  const std::string in = folder.Write("in.g2o", kGraph).string();
  const std::filesystem::path out = folder.path() / "out.g2o";
  const Ran ran =
      RunSlam({"optimize", in, "--out", out.string(), "--robust", "huber", "--width", "0.01"});
  EXPECT_EQ(ran.status, 0) << ran.err;
  // Pulled with a force of 0.01.
  const auto graph = std::get<agent::PlanarPoseGraph>(ReadG2o(out));
  EXPECT_NEAR(graph.vertices[2].pose.x, 1.72, 1e-4);
}

TEST(SlamOptimize, TellsBadUseInOneLine) {
  const tests::TemporaryFolder folder;
  const std::string in = folder.Write("in.g2o", kGraph).string();
  const std::string out = (folder.path() / "out.g2o").string();
  EXPECT_THAT(RunSlam({"optimize", in, "--out", out, "--robust", "tukey"}).err,
              HasSubstr("--robust"));
  EXPECT_THAT(RunSlam({"optimize", in}).err, HasSubstr("--out"));
  const std::string pieces =
      folder.Write("pieces.g2o", "VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 1 0 0\n").string();
  const Ran ran = RunSlam({"optimize", pieces, "--out", out});
  EXPECT_EQ(ran.status, 1);
  EXPECT_THAT(ran.err, HasSubstr("pieces.g2o: the pose graph is in 2 pieces"));
  EXPECT_FALSE(std::filesystem::exists(out));
  EXPECT_EQ(RunSlam({"optimize", pieces, "--out", out, "--pieces"}).status, 0);
}

/// A room of 8 x 6 m: a floor and nothing else.
constexpr const char* kFloor = "v 0 0 0\nv 8 0 0\nv 8 0 -6\nv 0 0 -6\nf 1 2 3\nf 1 3 4\n";

TEST(SlamTraverse, WritesARecordingOnce) {
  const tests::TemporaryFolder folder;
  const std::string scene = folder.Write("floor.obj", kFloor).string();
  const std::filesystem::path out = folder.path() / "run";
  const std::vector<std::string> words = {"traverse", scene,    "--out", out.string(), "--actions",
                                          "4",        "--rows", "24",    "--cols",     "32"};
  const Ran ran = RunSlam(words);
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_THAT(ran.err, HasSubstr("5 frames"));
  EXPECT_EQ(ReadTumFolder(out, {}).frames.size(), 5u);
  const Ran again = RunSlam(words);
  EXPECT_EQ(again.status, 1);
  EXPECT_THAT(again.err, HasSubstr("run: holds a recording already"));
}

/// Played, shown, drawn, and played no more.
TEST(SlamRun, PlaysDrawsAndGoesOn) {
  const tests::TemporaryFolder folder;
  const std::string scene = folder.Write("floor.obj", kFloor).string();
  const std::string config =
      folder
          .Write("c.yaml", "scenes: [" + scene +
                               "]\nactions: [30]\ncamera: {rows: 24, cols: 32}\n"
                               "detectors: [{detector: seqslam}]\n")
          .string();
  const std::string out = (folder.path() / "run").string();
  const Ran ran = RunSlam({"run", config, "apart_m=1", "--out", out, "--workers", "1"});
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_THAT(ran.out, HasSubstr("Drives of 30 actions (1)"));
  for (const char* file :
       {"table.md", "summary.json", "times.md", "config.yaml", "plots/precision_recall.svg",
        "plots/headings.png", "plots/floor_30_0.svg"}) {
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "run" / file)) << file;
  }
  const Ran again = RunSlam({"table", out});
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_EQ(again.out, ran.out);
  const Ran other = RunSlam({"run", config, "apart_m=2", "--out", out});
  EXPECT_EQ(other.status, 1);
  EXPECT_THAT(other.err, HasSubstr("config.yaml: is another config than this run's"));
  EXPECT_THAT(RunSlam({"plot", folder.path().string()}).err, HasSubstr("holds no results"));
  EXPECT_THAT(RunSlam({"run", config, "nosuch=1", "--out", out}).err, HasSubstr("nosuch"));
}

/// As where results are committed without them: what is there is drawn, also of detectors that are
/// added later.
TEST(SlamRun, DrawsWhatADriveStillHas) {
  const tests::TemporaryFolder folder;
  const std::string scene = folder.Write("floor.obj", kFloor).string();
  const auto config = [&](const std::string& detectors) {
    return folder
        .Write("c.yaml", "scenes: [" + scene +
                             "]\nactions: [30]\ncamera: {rows: 24, cols: 32}\napart_m: 1\n"
                             "detectors: [" +
                             detectors + "]\n")
        .string();
  };
  const std::filesystem::path out = folder.path() / "run";
  const std::string first = "{detector: seqslam}";
  ASSERT_EQ(RunSlam({"run", config(first), "--out", out.string(), "--workers", "1"}).status, 0);
  const std::filesystem::path drive = out / "drives" / "floor_30_0";
  ASSERT_TRUE(std::filesystem::remove(drive / "seqslam.tum"));
  std::filesystem::remove_all(out / "plots");
  const std::string more =
      first + ", {detector: seqslam, name: other, parameters: {contrast_window: 5}}";
  const Ran ran = RunSlam({"run", config(more), "--out", out.string(), "--workers", "1"});
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_THAT(ran.err, HasSubstr("1 of 1 drives do not keep all their trajectories"));
  EXPECT_TRUE(std::filesystem::exists(out / "plots" / "floor_30_0.svg"));
  ASSERT_TRUE(std::filesystem::remove(drive / "odometry.tum"));
  const Ran bare = RunSlam({"plot", out.string()});
  EXPECT_EQ(bare.status, 0) << bare.err;
  EXPECT_THAT(bare.err, HasSubstr("3 pictures"));
}

}  // namespace
}  // namespace bulletnav::bench
