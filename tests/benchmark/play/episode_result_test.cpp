// SPDX-License-Identifier: MIT
#include "benchmark/play/episode_result.h"

#include <limits>
#include <string>

#include <gmock/gmock.h>

#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr const char* kKey =
    R"({"agent":"nts","setting":"rgbd","condition":"noise","seed":3,"scene":"h.glb","episode":"7",)"
    R"("difficulty":"hard","failure":null)";
constexpr const char* kGoal =
    R"("success":true,"success_euclidean":false,"spl":0.1,"soft_spl":0.3333333333333333,)"
    R"("start_distance":7.0,"distance_to_goal":null,"euclidean_distance":1e-17,)"
    R"("path_length":12.3,"steps":500,"collisions":2)";

GoalMetrics Goal() {
  return {{"success", 1.0},
          {"success_euclidean", 0.0},
          {"spl", 0.1},
          {"soft_spl", 1.0 / 3.0},
          {"start_distance", 7.0},
          {"distance_to_goal", std::numeric_limits<double>::infinity()},
          {"euclidean_distance", 1e-17},
          {"path_length", 12.3},
          {"steps", 500.0},
          {"collisions", 2.0}};
}

EpisodeResult Result(std::vector<GoalMetrics> goals) {
  return {{"nts", "rgbd", "noise", 3, "h.glb", "7"}, Difficulty::kHard, std::move(goals), ""};
}

/// A line of one goal with one text in it replaced.
std::string Line(const std::string& from = "", const std::string& to = "") {
  std::string line = std::string(kKey) + "," + kGoal + "}";
  const std::size_t at = line.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return line.replace(at, from.size(), to);
}

std::string ComplaintAbout(const std::string& line) {
  try {
    FromJsonLine(line, "x.jsonl", 12);
  } catch (const sim::FileError& e) {
    return e.what();
  }
  return "";
}

/// Files of results are compared byte for byte.
TEST(EpisodeResult, LinesAreTheseBytes) {
  EXPECT_EQ(ToJsonLine(Result({Goal()})), Line());
  EXPECT_EQ(ToJsonLine(Result({Goal(), Goal()})),
            std::string(kKey) + ",\"goals\":[{" + kGoal + "},{" + kGoal + "}]}");
  EXPECT_EQ(FromJsonLine(Line(), "x.jsonl", 1), Result({Goal()}));
}

TEST(EpisodeResult, OlderLinesLackMeasures) {
  const std::string line = Line(R"("soft_spl":0.3333333333333333,)");
  const EpisodeResult result = FromJsonLine(line, "x.jsonl", 1);
  EXPECT_EQ(result.goals[0].Find("soft_spl"), std::nullopt);
  EXPECT_EQ(result.goals[0].Value("path_length"), 12.3);
  EXPECT_EQ(ToJsonLine(result), line) << "nothing is made up";
}

TEST(EpisodeResult, NewerLinesHaveMore) {
  const std::string line = Line(R"("steps":500)", R"("reward":{"sum":-1},"steps":500)");
  EXPECT_EQ(FromJsonLine(line, "x.jsonl", 1), Result({Goal()}));
}

TEST(EpisodeResult, WrongValuesAreNamedWithTheirPlace) {
  EXPECT_THAT(ComplaintAbout(Line("true", "1")),
              AllOf(HasSubstr("x.jsonl:12"), HasSubstr("success"), HasSubstr("true or false")));
  EXPECT_THAT(ComplaintAbout(Line(R"("steps":500)", R"("steps":0.5)")),
              AllOf(HasSubstr("steps"), HasSubstr("whole number")));
  EXPECT_THAT(ComplaintAbout(Line(R"("spl":0.1)", R"("spl":null)")), HasSubstr("spl"));
  EXPECT_THAT(ComplaintAbout(Line(R"("success":true,)")), HasSubstr("success"));
}

}  // namespace
}  // namespace bulletnav::bench
