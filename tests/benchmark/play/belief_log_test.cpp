// SPDX-License-Identifier: MIT
#include "benchmark/play/belief_log.h"

#include <string_view>
#include <vector>

#include <gmock/gmock.h>

#include "benchmark/base/gzip.h"
#include "benchmark/base/json_cursor.h"
#include "benchmark/play/belief_reader.h"
#include "sim/base/error.h"
#include "sim/base/files.h"
#include "sim/math/rng.h"
#include "tests/support/temporary_folder.h"

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

bool operator==(const agent::MapPicture& a, const agent::MapPicture& b) {
  return a.size == b.size && a.low_x == b.low_x && a.kinds == b.kinds;
}

TEST(BeliefLogTest, IsReadBackStepByStep) {
  constexpr int kSteps = 40;
  sim::Rng rng(5, "beliefs");
  BeliefLog log;
  std::vector<agent::Belief> told;
  agent::Belief belief = Believed(std::vector<Kind>(9, Kind::kUnknown));
  belief.graph.emplace();
  for (int step = 0; step < kSteps; ++step) {
    belief.map->kinds[rng.Below(9)] = static_cast<Kind>(rng.Below(4));
    if (step % 7 == 3) belief.map->low_x += 1.0;
    if (step % 5 == 2) belief.target = {0.5 * step, 1.0, 0.0};
    if (step % 5 == 4) belief.target.reset();
    if (step % 3 == 1) {
      belief.graph->nodes.push_back({0.25 * step, -1.0, step % 2 == 0, 0.125});
      belief.graph->edges.emplace_back(0, step / 3);
      belief.graph->path = {0, step / 3};
    }
    log.Add(belief);
    told.push_back(belief);
  }
  const tests::TemporaryFolder folder;
  sim::WriteFileAtomically(folder.path() / "b.json.gz", Compress(log.ToJson()));
  BeliefReader reader(folder.path() / "b.json.gz");
  ASSERT_EQ(reader.size(), told.size());
  for (std::size_t i : {0, 1, 2, 9, 10, 23, 24, 39}) {
    const agent::Belief& read = reader.At(i);
    EXPECT_EQ(read.target.has_value(), told[i].target.has_value()) << i;
    if (read.target) {
      EXPECT_EQ(read.target->x, told[i].target->x) << i;
    }
    EXPECT_TRUE(*read.map == *told[i].map) << i;
    EXPECT_EQ(read.graph->nodes, told[i].graph->nodes) << i;
    EXPECT_EQ(read.graph->edges, told[i].graph->edges) << i;
    EXPECT_EQ(read.graph->path, told[i].graph->path) << i;
  }
  sim::WriteFileAtomically(folder.path() / "bad.gz", Compress(R"({"cell":1,"size":2,
      "frames":[{"low":[0,0],"m":[2,13]}]})"));
  EXPECT_THROW(BeliefReader(folder.path() / "bad.gz").At(0), sim::FileError);
  sim::WriteFileAtomically(folder.path() / "cut.gz", std::string_view("x"));
  EXPECT_THROW(BeliefReader(folder.path() / "cut.gz"), sim::FileError);
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
  EXPECT_EQ(BeliefPath("run", key), "run/beliefs/nts-rgbd-noise-3/a%2Fhouse-easy%2F0.json.gz");
}

}  // namespace
}  // namespace bulletnav::bench
