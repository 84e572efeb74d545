// SPDX-License-Identifier: MIT
#include "benchmark/report/run_tables.h"

#include <gmock/gmock.h>

#include "benchmark/report/scene_table.h"
#include "sim/base/files.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::bench {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

EpisodeResult Result(const std::string& agent, const std::string& condition, int i) {
  EpisodeResult result;
  result.key = {agent, "rgbd", condition, 0, "house.glb", std::to_string(i)};
  result.difficulty = kDifficulties[static_cast<std::size_t>(i) % 3];
  GoalMetrics metrics;
  metrics["success"] = i % 2 == 0;
  metrics["success_euclidean"] = i % 4 != 1;
  metrics["spl"] = metrics.success() ? 0.5 : 0.0;
  result.goals = {metrics};
  return result;
}

std::vector<EpisodeResult> Results(const std::vector<std::string>& conditions) {
  std::vector<EpisodeResult> results;
  for (const std::string& condition : conditions) {
    for (const char* agent : {"nts", "random"}) {
      for (int i = 0; i < 12; ++i) results.push_back(Result(agent, condition, i));
    }
  }
  return results;
}

const std::vector<AgentRow>& Agents() {
  static const std::vector<AgentRow> agents = {
      {"random", "Random", {}, ""},
      {"nts", "", {{"rgbd", 1'500'000}}, "oracle"},
      {"active_neural_slam", "", {}, "weights missing: assets/weights/ans"}};
  return agents;
}

std::string Markdown(const std::vector<EpisodeResult>& results) {
  std::string text;
  for (const auto& table : MakeTables(Summarize(results, Agents()), Agents())) {
    text += ToMarkdown(table);
  }
  return text;
}

TEST(RunTables, FirstTableIsLaidOutLikeThePapers) {
  const std::string text = Markdown(Results({"noise"}));
  EXPECT_THAT(
      text,
      HasSubstr("|  | Model | Easy Succ | Easy SPL | Medium Succ | Medium SPL | Hard "
                "Succ | Hard SPL | Overall Succ | Overall SPL | Euclidean Succ | This run |\n"));
  EXPECT_THAT(text, HasSubstr("| RGBD | Random | 0.50 | 0.25 | 0.50 | 0.25 | 0.50 | 0.25 | 0.50 | "
                              "0.25 | 0.75 | 12 episodes, 95%: 0.25-0.75 / 0."));
  EXPECT_THAT(text, HasSubstr("Neural Topological SLAM (NTS) | 0.50"));
  EXPECT_THAT(text, HasSubstr(", 1.5M frames, oracle |\n"));
}

TEST(RunTables, PapersFiguresStandBesideOursAndAreLabelled) {
  EXPECT_THAT(
      Markdown(Results({"noise"})),
      HasSubstr("| RGBD | *Neural Topological SLAM (NTS), paper, Gibson* | *0.87* | *0.65* | "
                "*0.58* | *0.38* | *0.43* | *0.26* | *0.63* | *0.43* |  |  |\n"));
  EXPECT_THAT(Markdown(Results({"noise"})), Not(HasSubstr("Random, paper")));
}

TEST(RunTables, ATitleOfOnesOwnLeavesThePapersAlone) {
  const std::vector<AgentRow> agents = {{"nts", "Ours | new", {}, ""}};
  const std::string text = ToMarkdown(MakeTables(Summarize(Results({"noise"}), agents), agents)[0]);
  EXPECT_THAT(text, AllOf(HasSubstr("| RGBD | Ours \\| new | 0.50"),
                          HasSubstr("*Neural Topological SLAM (NTS), paper, Gibson*")));
}

TEST(RunTables, AgentWithoutResultsSaysWhyAndShowsThePapers) {
  EXPECT_THAT(Markdown(Results({"noise"})),
              AllOf(HasSubstr("| Active Neural SLAM (ANS) |  |  |  |  |  |  |  |  |  | weights "
                              "missing: assets/weights/ans |"),
                    HasSubstr("| RGB | *Active Neural SLAM (ANS), paper, Gibson* | *0.63* |"),
                    HasSubstr("| RGBD | *Active Neural SLAM (ANS), paper, Gibson* | *0.76* |")));
  std::vector<EpisodeResult> by_other_rules = Results({"noise"});
  for (EpisodeResult& result : by_other_rules) result.key.setting = "habitat";
  EXPECT_THAT(Markdown(by_other_rules),
              AllOf(HasSubstr("| Active Neural SLAM (ANS) |"), Not(HasSubstr("Gibson* |"))));
}

TEST(RunTables, SecondTableHasTheConditionsOfTheRun) {
  const std::string both = Markdown(Results({"no_noise", "no_stop"}));
  EXPECT_THAT(both,
              HasSubstr("| No stop Easy | No stop Medium | No stop Hard | No stop Overall | No "
                        "noise Easy |"));
  EXPECT_THAT(both, HasSubstr("*0.94* | *0.70* | *0.60* | *0.75* | *0.87* | *0.60* | *0.46* | "
                              "*0.64* |"));
  EXPECT_THAT(both, Not(HasSubstr("SPL |")));
  EXPECT_THAT(both, HasSubstr("Success without stop action and without motion noise.\n"));
  EXPECT_THAT(Markdown(Results({"no_stop"})),
              AllOf(HasSubstr("Success without stop action.\n"), Not(HasSubstr("oise"))));
}

TEST(RunTables, RunsWithoutNoiseAloneHaveSpl) {
  EXPECT_THAT(Markdown(Results({"no_noise"})),
              AllOf(HasSubstr("Success and SPL by difficulty, without motion noise.\n"),
                    HasSubstr("| Easy Succ | Easy SPL |"), HasSubstr("| Overall SPL |")));
}

std::vector<EpisodeResult> Sequences(const std::vector<std::string>& conditions) {
  std::vector<EpisodeResult> results = Results(conditions);
  for (EpisodeResult& result : results) {
    result.difficulty.reset();
    result.goals.resize(3, result.goals[0]);
  }
  return results;
}

TEST(RunTables, SequencesGetAColumnForEachNumberOfGoals) {
  EXPECT_THAT(Markdown(Sequences({"noise"})),
              AllOf(HasSubstr("| 1 Succ | 1 SPL | 2 Succ | 2 SPL | 3 Succ |"),
                    Not(HasSubstr("Easy")), Not(HasSubstr("Gibson"))));
}

TEST(RunTables, SequencesGetATableForEachCondition) {
  const std::string text = Markdown(Sequences({"noise", "no_stop"}));
  EXPECT_THAT(text, AllOf(HasSubstr("sequential goals.\n"),
                          HasSubstr("sequential goals, without stop action.\n"),
                          Not(HasSubstr("Easy")), Not(HasSubstr("Gibson"))));
}

TEST(RunTables, FailedEpisodesAreCountedAndSaid) {
  std::vector<EpisodeResult> results = Results({"noise"});
  results[0].failure = "threw: no map";
  EXPECT_THAT(Markdown(results), HasSubstr("12 episodes, 1 of them failed"));
}

TEST(RunTables, LatexIsEscapedAndComplete) {
  std::vector<AgentRow> agents = {{"random", "50% of A_B & C ~^\\", {}, ""}};
  const auto rows = Summarize(Results({"noise"}), agents);
  const std::string text = ToLatex(MakeTables(rows, agents)[0]);
  EXPECT_THAT(text, AllOf(HasSubstr("\\begin{tabular}{llrrrrrrrrrl}"),
                          HasSubstr("\\multicolumn{2}{c}{Easy}"),
                          HasSubstr("50\\% of A\\_B \\& C \\textasciitilde{}\\textasciicircum{}"
                                    "\\textbackslash{} &"),
                          HasSubstr("\\emph{0.87}"), HasSubstr("\\end{tabular}")));
  // Each line of the body has as many cells.
  EXPECT_THAT(text, HasSubstr(" & Model & Succ & SPL & Succ & SPL & Succ & SPL & Succ & SPL & "));
}

TEST(RunTables, FolderGetsAllFourFiles) {
  const tests::TemporaryFolder folder;
  const std::string text = WriteTables(folder.path(), Results({"noise", "no_stop"}), Agents());
  EXPECT_EQ(sim::ReadTextFile(folder.path() / "table.md"), text);
  EXPECT_THAT(text, HasSubstr("side by side"));
  for (const char* name : {"summary.json", "table.tex", "table.csv"}) {
    EXPECT_FALSE(sim::ReadTextFile(folder.path() / name).empty());
  }
  EXPECT_THAT(WriteTables(folder.path(), {}, Agents()), HasSubstr("No results yet"));
}

TEST(RunTables, FurtherDifficultiesHaveColumnsWhereThereAreSome) {
  std::vector<EpisodeResult> results = Results({"noise"});
  EXPECT_THAT(Markdown(results), Not(HasSubstr("Very hard")));
  results.front().difficulty = Difficulty::kVeryHard;
  EXPECT_THAT(Markdown(results),
              HasSubstr("| Hard SPL | Very hard Succ | Very hard SPL | Overall"));
}

/// The paper's overall is of three bands, and a band that was not played has no figure beside it.
TEST(RunTables, PapersFiguresStandBelowTheSameBandsAlone) {
  std::vector<EpisodeResult> results = Results({"noise"});
  const std::string whole = "*0.43* | *0.26* | *0.63* | *0.43* |";
  EXPECT_THAT(Markdown(results), HasSubstr(whole));
  results.front().difficulty = Difficulty::kVeryHard;
  const std::string more = Markdown(results);
  EXPECT_THAT(more, AllOf(HasSubstr("*0.43* | *0.26* |"), Not(HasSubstr("*0.63* | *0.43*"))));
  for (EpisodeResult& result : results) result.difficulty = Difficulty::kVeryHard;
  EXPECT_THAT(Markdown(results), Not(HasSubstr("paper, Gibson*")));
}

TEST(SceneTable, HasARowASceneAndSaysWhichIsWhich) {
  std::vector<EpisodeResult> results = Results({"noise", "no_stop"});
  EXPECT_FALSE(SceneTable(results, Agents()).has_value());  // a single one
  for (std::size_t i = 0; i < results.size(); ++i) {
    results[i].key.scene = i % 2 == 0 ? "shop/scene.obj" : "office/scene.obj";
  }
  const auto table = SceneTable(results, Agents());
  ASSERT_TRUE(table);
  ASSERT_EQ(table->rows.size(), 2u);
  EXPECT_EQ(table->rows[0].title, "office/scene");
  EXPECT_THAT(ToMarkdown(*table), HasSubstr("|  | Scene | "));
  EXPECT_EQ(table->rows[1].title, "shop/scene");
  // Even episodes are in the shop, and are the ones that succeed; random comes first.
  EXPECT_EQ(table->rows[1].cells, (std::vector<std::string>{"1.00", "0.50", "1.00", "0.50"}));
  EXPECT_EQ(table->rows[0].cells, (std::vector<std::string>{"0.00", "0.00", "0.00", "0.00"}));
  EXPECT_EQ(table->rows[0].remark, "6 episodes");
}

}  // namespace
}  // namespace bulletnav::bench
