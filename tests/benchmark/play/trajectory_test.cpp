// SPDX-License-Identifier: MIT
#include "benchmark/play/trajectory.h"

#include <filesystem>
#include <set>
#include <string>

#include <gmock/gmock.h>

#include "sim/base/error.h"
#include "sim/base/files.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/trajectories.h"

namespace bulletnav::bench {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr double kRounding = 0.51e-6;

EpisodeTrajectory ReadBack(const std::string& json) {
  const tests::TemporaryFolder folder;
  return ReadTrajectory(folder.Write("t.json", json));
}

/// The text with its first `from` replaced by `to`.
std::string Replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

std::string ComplaintAbout(const std::string& json) {
  try {
    ReadBack(json);
  } catch (const sim::FileError& e) {
    return e.what();
  }
  return "";
}

TEST(Trajectory, ReadsBackWhatWasWritten) {
  const EpisodeTrajectory written = tests::MadeUpTrajectory();
  const EpisodeTrajectory read = ReadBack(ToJson(written));
  EXPECT_EQ(read.result, written.result);
  EXPECT_EQ(read.scene_file, written.scene_file);
  EXPECT_EQ(read.key.run_seed, written.key.run_seed);
  EXPECT_EQ(read.key.episode, written.key.episode) << "all 64 bits";
  EXPECT_EQ(read.noise, written.noise);
  EXPECT_EQ(read.body.radius, written.body.radius);
  EXPECT_EQ(read.body.camera_height, written.body.camera_height);
  EXPECT_EQ(read.body.sliding, written.body.sliding);
  EXPECT_EQ(read.start.position, written.start.position);
  EXPECT_EQ(read.goals[0].yaw, written.goals[0].yaw);
  EXPECT_EQ(read.shortest_path, written.shortest_path);
  ASSERT_EQ(read.steps.size(), written.steps.size());
  for (std::size_t i = 0; i < read.steps.size(); ++i) {
    EXPECT_EQ(read.steps[i].action, written.steps[i].action);
    EXPECT_EQ(read.steps[i].collided, written.steps[i].collided);
    EXPECT_LT((read.steps[i].pose.position - written.steps[i].pose.position).norm(), 2 * kRounding);
    EXPECT_NEAR(read.steps[i].odometry.x, written.steps[i].odometry.x, kRounding);
    EXPECT_NEAR(read.steps[i].odometry.yaw, written.steps[i].odometry.yaw, kRounding);
  }
}

TEST(Trajectory, BeliefsReadBack) {
  const agent::Belief written = tests::MadeUpTrajectory().belief;
  const agent::Belief read = ReadBack(ToJson(tests::MadeUpTrajectory())).belief;
  EXPECT_EQ(read.target->y, written.target->y);
  EXPECT_EQ(read.map->kinds, written.map->kinds);
  EXPECT_EQ(read.map->low_x, written.map->low_x);
  EXPECT_EQ(read.graph->nodes, written.graph->nodes);
  EXPECT_EQ(read.graph->edges, written.graph->edges);
}

TEST(Trajectory, WritingWhatWasReadGivesTheSameBytes) {
  const std::string json = ToJson(tests::MadeUpTrajectory());
  EXPECT_EQ(ToJson(ReadBack(json)), json);
}

TEST(Trajectory, EpisodeWithoutStepsOrBeliefReadsBack) {
  EpisodeTrajectory trajectory = tests::MadeUpTrajectory();
  trajectory.steps.clear();
  trajectory.belief = {};
  const EpisodeTrajectory read = ReadBack(ToJson(trajectory));
  EXPECT_TRUE(read.steps.empty());
  EXPECT_FALSE(read.belief.pose || read.belief.map || read.belief.graph);
}

TEST(Trajectory, DamageIsNamedWithItsPlace) {
  const std::string json = ToJson(tests::MadeUpTrajectory());
  EXPECT_THAT(ComplaintAbout(json.substr(0, json.size() / 2)), HasSubstr("cut off"));
  EXPECT_THAT(ComplaintAbout(Replaced(json, "\"FFF", "\"FFX")), HasSubstr("actions"));
  EXPECT_THAT(ComplaintAbout(Replaced(json, "\"FFF", "\"FF")), HasSubstr("actions"));
  EXPECT_THAT(ComplaintAbout(Replaced(json, "\"physical\"", "\"loud\"")),
              AllOf(HasSubstr("noise"), HasSubstr("loud")));
  EXPECT_THAT(ComplaintAbout(Replaced(json, "\"2.1#\"", "\"3.1#\"")),
              AllOf(HasSubstr("belief.map.rows[1]"), HasSubstr("too long")));
  EXPECT_THAT(ComplaintAbout(Replaced(json, "\"2.1#\"", "\"1.1#\"")), HasSubstr("too short"));
  EXPECT_THAT(ComplaintAbout(Replaced(json, "\"2.1#\"", "\"99999999999999999999.\"")),
              HasSubstr("too long"));
  EXPECT_THAT(ComplaintAbout(Replaced(json, "[1,2]", "[1,3]")), HasSubstr("edges[1][1]"));
  EXPECT_THAT(ComplaintAbout(Replaced(json, "\"poses\":[[", "\"poses\":[[1,")),
              HasSubstr("poses[0]"));
}

TEST(Trajectory, PathsAreFileNamesAndNoTwoResultsShareOne) {
  const ResultKey key = {"my agent", "rgbd", "noise", 3, "data/../hou se.basis.glb", "../a/b:1"};
  EXPECT_EQ(TrajectoryPath("run", key),
            "run/trajectories/my agent-rgbd-noise-3/hou se.basis-..%2Fa%2Fb:1.json");
  std::set<std::filesystem::path> paths;
  for (const char* name : {"a b", "a_b", "a/b", "a%2Fb", "ü", "ö", "家", "宅", "a\nb"}) {
    const ResultKey of_agent = {name, "rgbd", "noise", 0, "house.glb", "1"};
    const ResultKey of_scene = {"nts", "rgbd", "noise", 0, std::string("house.glb"), name};
    EXPECT_TRUE(paths.insert(TrajectoryPath("run", of_agent)).second) << name;
    EXPECT_TRUE(paths.insert(TrajectoryPath("run", of_scene)).second) << name;
  }
}

}  // namespace
}  // namespace bulletnav::bench
