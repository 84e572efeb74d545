// SPDX-License-Identifier: MIT
#include "benchmark/runs/published.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace bulletnav::bench {
namespace {

constexpr std::array<std::string_view, 4> kColumns = {"easy", "medium", "hard", "overall"};

/// Figures by column: table 1, then table 2.
struct Line {
  std::string_view agent;
  std::string_view setting;
  std::string_view condition;
  std::string_view measure;
  std::array<double, 4> figures;
};

constexpr std::array kLines = {
    Line{"resnet_gru_il", "rgb", "noise", "success", {.57, .14, .04, .25}},
    Line{"resnet_gru_il", "rgb", "noise", "spl", {.23, .06, .02, .10}},
    Line{"target_driven_rl", "rgb", "noise", "success", {.56, .17, .06, .26}},
    Line{"target_driven_rl", "rgb", "noise", "spl", {.22, .06, .02, .10}},
    Line{"active_neural_slam", "rgb", "noise", "success", {.63, .31, .12, .35}},
    Line{"active_neural_slam", "rgb", "noise", "spl", {.45, .18, .07, .23}},
    Line{"nts", "rgb", "noise", "success", {.80, .47, .37, .55}},
    Line{"nts", "rgb", "noise", "spl", {.60, .31, .22, .38}},
    Line{"resnet_gru_il", "rgbd", "noise", "success", {.72, .16, .05, .31}},
    Line{"resnet_gru_il", "rgbd", "noise", "spl", {.32, .09, .02, .14}},
    Line{"target_driven_rl", "rgbd", "noise", "success", {.68, .21, .09, .33}},
    Line{"target_driven_rl", "rgbd", "noise", "spl", {.28, .08, .03, .13}},
    Line{"metric_map_rl", "rgbd", "noise", "success", {.69, .22, .12, .34}},
    Line{"metric_map_rl", "rgbd", "noise", "spl", {.27, .07, .04, .13}},
    Line{"metric_map_fbe", "rgbd", "noise", "success", {.77, .36, .13, .42}},
    Line{"metric_map_fbe", "rgbd", "noise", "spl", {.56, .18, .05, .26}},
    Line{"active_neural_slam", "rgbd", "noise", "success", {.76, .40, .16, .44}},
    Line{"active_neural_slam", "rgbd", "noise", "spl", {.55, .24, .09, .29}},
    Line{"nts", "rgbd", "noise", "success", {.87, .58, .43, .63}},
    Line{"nts", "rgbd", "noise", "spl", {.65, .38, .26, .43}},
    Line{"resnet_gru_il", "rgbd", "no_stop", "success", {.76, .28, .10, .38}},
    Line{"target_driven_rl", "rgbd", "no_stop", "success", {.89, .45, .21, .52}},
    Line{"metric_map_rl", "rgbd", "no_stop", "success", {.89, .45, .21, .52}},
    Line{"metric_map_fbe", "rgbd", "no_stop", "success", {.92, .46, .29, .56}},
    Line{"active_neural_slam", "rgbd", "no_stop", "success", {.93, .50, .32, .58}},
    Line{"nts", "rgbd", "no_stop", "success", {.94, .70, .60, .75}},
    Line{"resnet_gru_il", "rgbd", "no_noise", "success", {.71, .18, .06, .32}},
    Line{"target_driven_rl", "rgbd", "no_noise", "success", {.69, .22, .07, .33}},
    Line{"metric_map_rl", "rgbd", "no_noise", "success", {.70, .24, .11, .35}},
    Line{"metric_map_fbe", "rgbd", "no_noise", "success", {.78, .46, .23, .49}},
    Line{"active_neural_slam", "rgbd", "no_noise", "success", {.79, .53, .30, .54}},
    Line{"nts", "rgbd", "no_noise", "success", {.87, .60, .46, .64}},
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
    Title{"nts_paper", "NTS, the paper's rules alone"},
    Title{"nts_without_graph", "NTS w/o Graph"},
    Title{"nts_without_score", "NTS w/o Score Function"},
};

}  // namespace

std::optional<double> FindPublished(std::string_view measure, std::string_view agent,
                                    std::string_view setting, std::string_view condition,
                                    std::string_view difficulty) {
  const auto found = std::find(kColumns.begin(), kColumns.end(), difficulty);
  if (found == kColumns.end()) return std::nullopt;
  for (const Line& line : kLines) {
    if (line.agent == agent && line.setting == setting && line.condition == condition &&
        line.measure == measure) {
      return line.figures[static_cast<std::size_t>(found - kColumns.begin())];
    }
  }
  return std::nullopt;
}

std::string_view PublishedTitle(std::string_view agent) {
  for (const Title& title : kTitles) {
    if (title.agent == agent) return title.title;
  }
  return {};
}

}  // namespace bulletnav::bench
