// SPDX-License-Identifier: MIT
#include "benchmark/runs/published.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace bulletnav::bench {
namespace {

constexpr std::array<std::string_view, 4> kColumns = {"easy", "medium", "hard", "overall"};

/// One line of table 1: success and SPL by column.
struct Line {
  std::string_view agent;
  std::string_view setting;
  std::array<double, 4> success;
  std::array<double, 4> spl;
};

constexpr std::array kTable1 = {
    Line{"resnet_gru_il", "rgb", {.57, .14, .04, .25}, {.23, .06, .02, .10}},
    Line{"target_driven_rl", "rgb", {.56, .17, .06, .26}, {.22, .06, .02, .10}},
    Line{"active_neural_slam", "rgb", {.63, .31, .12, .35}, {.45, .18, .07, .23}},
    Line{"nts", "rgb", {.80, .47, .37, .55}, {.60, .31, .22, .38}},
    Line{"resnet_gru_il", "rgbd", {.72, .16, .05, .31}, {.32, .09, .02, .14}},
    Line{"target_driven_rl", "rgbd", {.68, .21, .09, .33}, {.28, .08, .03, .13}},
    Line{"metric_map_rl", "rgbd", {.69, .22, .12, .34}, {.27, .07, .04, .13}},
    Line{"metric_map_fbe", "rgbd", {.77, .36, .13, .42}, {.56, .18, .05, .26}},
    Line{"active_neural_slam", "rgbd", {.76, .40, .16, .44}, {.55, .24, .09, .29}},
    Line{"nts", "rgbd", {.87, .58, .43, .63}, {.65, .38, .26, .43}},
};

/// One line of table 2, RGBD: success by column.
struct SuccessLine {
  std::string_view agent;
  std::array<double, 4> no_stop;
  std::array<double, 4> no_noise;
};

constexpr std::array kTable2 = {
    SuccessLine{"resnet_gru_il", {.76, .28, .10, .38}, {.71, .18, .06, .32}},
    SuccessLine{"target_driven_rl", {.89, .45, .21, .52}, {.69, .22, .07, .33}},
    SuccessLine{"metric_map_rl", {.89, .45, .21, .52}, {.70, .24, .11, .35}},
    SuccessLine{"metric_map_fbe", {.92, .46, .29, .56}, {.78, .46, .23, .49}},
    SuccessLine{"active_neural_slam", {.93, .50, .32, .58}, {.79, .53, .30, .54}},
    SuccessLine{"nts", {.94, .70, .60, .75}, {.87, .60, .46, .64}},
};

struct Title {
  std::string_view agent;
  std::string_view title;
};

constexpr std::array kTitles = {
    Title{"resnet_gru_il", "ResNet + GRU + IL"},
    Title{"target_driven_rl", "Target-driven RL"},
    Title{"metric_map_rl", "Metric Spatial Map + RL"},
    Title{"metric_map_fbe", "Metric Spatial Map + FBE + Local"},
    Title{"active_neural_slam", "Active Neural SLAM (ANS)"},
    Title{"nts", "Neural Topological SLAM (NTS)"},
    Title{"nts_without_graph", "NTS w/o Graph"},
    Title{"nts_without_score", "NTS w/o Score Function"},
};

}  // namespace

PublishedFigure FindPublished(std::string_view agent, std::string_view setting,
                              std::string_view condition, std::string_view difficulty) {
  const auto found = std::find(kColumns.begin(), kColumns.end(), difficulty);
  if (found == kColumns.end()) return {};
  const auto column = static_cast<std::size_t>(found - kColumns.begin());
  if (condition == "noise") {
    for (const Line& line : kTable1) {
      if (line.agent != agent || line.setting != setting) continue;
      return {line.success[column], line.spl[column]};
    }
  }
  if (setting != "rgbd") return {};
  for (const SuccessLine& line : kTable2) {
    if (line.agent != agent) continue;
    if (condition == "no_stop") return {line.no_stop[column], std::nullopt};
    if (condition == "no_noise") return {line.no_noise[column], std::nullopt};
  }
  return {};
}

std::string_view PublishedTitle(std::string_view agent) {
  for (const Title& title : kTitles) {
    if (title.agent == agent) return title.title;
  }
  return {};
}

}  // namespace bulletnav::bench
