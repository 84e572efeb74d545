// SPDX-License-Identifier: MIT
#include "benchmark/play/belief_log.h"

#include <gmock/gmock.h>

#include "benchmark/base/json_cursor.h"

namespace bulletnav::bench {
namespace {

using Kind = agent::MapPicture::Kind;

/// A belief with a map of 3 x 3 cells.
agent::Belief Believed(std::vector<Kind> kinds, double low_x = -1.0) {
  agent::Belief belief;
  belief.pose = {1.0, -0.0001, 0.5};
  belief.map = {3, 0.05, low_x, -1.0, std::move(kinds)};
  return belief;
}

/// What a reader of the file makes of its frames: the map after the last of them.
std::vector<int> Replayed(const Json& log) {
  std::vector<int> cells;
  for (const Json& frame : log["frames"]) {
    if (frame.contains("low")) cells.assign(9, 0);
    std::size_t at = 0;
    for (std::size_t i = 0; frame.contains("m") && i < frame["m"].size(); i += 2) {
      at += frame["m"][i].get<std::size_t>();
      const int code = frame["m"][i + 1].get<int>();
      for (int k = 0; k < code / 4; ++k) cells[at++] = code % 4;
    }
  }
  return cells;
}

TEST(BeliefLogTest, TellsChangesThatGiveTheMapBack) {
  const auto u = Kind::kUnknown;
  const auto f = Kind::kFree;
  const auto o = Kind::kObstacle;
  BeliefLog log;
  log.Add(Believed({u, u, f, f, o, u, u, u, u}));
  log.Add(Believed({u, u, f, f, o, u, u, u, u}));
  log.Add(Believed({f, u, f, o, o, u, u, u, Kind::kFeltWall}));
  const Json json = Json::parse(log.ToJson());
  EXPECT_EQ(json["cell"], 0.05);
  EXPECT_EQ(json["size"], 3);
  ASSERT_EQ(json["frames"].size(), 3u);
  EXPECT_EQ(json["frames"][0]["m"], Json({2, 9, 0, 6}));
  EXPECT_EQ(json["frames"][0]["p"], Json({1.0, 0.0, 0.5}));
  EXPECT_FALSE(json["frames"][1].contains("m"));
  EXPECT_EQ(Replayed(json), std::vector<int>({1, 0, 1, 2, 2, 0, 0, 0, 3}));
  log.Add(Believed({u, u, u, u, o, u, u, u, u}, 0.0));  // the map has moved
  EXPECT_EQ(Replayed(Json::parse(log.ToJson())), std::vector<int>({0, 0, 0, 0, 2, 0, 0, 0, 0}));
}

TEST(BeliefLogTest, TellsGraphAndTargetWhenTheyChange) {
  agent::Belief belief;
  belief.target = {2.0, 3.0, 0.0};
  belief.graph = {{{0.0, 0.0}, {1.5, -2.0, true, 0.25}}, {{0, 1}}, {0, 1}};
  BeliefLog log;
  log.Add(belief);
  belief.target.reset();
  belief.graph->path.clear();
  log.Add(belief);
  const Json frames = Json::parse(log.ToJson())["frames"];
  EXPECT_EQ(frames[0].dump(), R"({"t":[2,3],"n":[[0,0,0],[1.5,-2,1,0.25]],"e":[[0,1]],"w":[0,1]})");
  EXPECT_EQ(frames[1].dump(), R"({"t":null,"w":[]})");
}

TEST(BeliefLogTest, IsEmptyForAgentsThatTellNothing) {
  BeliefLog log;
  log.Add({});
  EXPECT_TRUE(log.empty());
  log.Add(Believed(std::vector<Kind>(9)));
  EXPECT_FALSE(log.empty());
}

TEST(BeliefLogTest, LiesBesideTheTrajectories) {
  const ResultKey key = {"nts", "rgbd", "noise", 3, "a/house.glb", "easy/0"};
  EXPECT_EQ(BeliefPath("run", key), "run/beliefs/nts-rgbd-noise-3/a_house-easy_0.json.gz");
}

}  // namespace
}  // namespace bulletnav::bench
