// SPDX-License-Identifier: MIT
#include "benchmark/evaluate_perception/score_figures.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "benchmark/base/ranking.h"

namespace bulletnav::bench {
namespace {

constexpr double kMetre = 1.0 / agent::kFarthestScored;  // as a score
constexpr double kRounding = 1e-6;                       // of scores in 255ths

/// What a place's explorable directions are worth for one goal.
struct Options {
  std::vector<double> truth;
  std::vector<double> said;
  std::vector<double> reach;      // what else directions may be preferred by
  std::vector<double> closeness;  // less metres in a straight line
  double best() const { return *std::max_element(truth.begin(), truth.end()); }
  bool HasChoice() const {
    return truth.size() > 1 &&
           best() - *std::min_element(truth.begin(), truth.end()) > kMetre + kRounding;
  }
};

Options OptionsOf(const SceneCases& cases, int source, int goal) {
  const SceneSamples& samples = cases.samples;
  const Eigen::Vector3d& at = samples.poses[static_cast<std::size_t>(goal)].position;
  Options options;
  for (int i = 0; i < agent::kDirections; ++i) {
    if (!samples.IsExplorable(source, i)) continue;
    const auto direction = static_cast<std::size_t>(i);
    options.truth.push_back(double{samples.pair(source, goal).far_score(i)});
    options.said.push_back(double{cases.prediction(source, goal).score[direction]});
    options.reach.push_back(1.0 * samples.reach[static_cast<std::size_t>(source)][direction]);
    options.closeness.push_back(-(samples.FarPoint(source, i).position - at).norm());
  }
  return options;
}

struct ChoiceSums {
  SceneMean best;
  SceneMean near;
  SceneMean extra;

  void NextScene() {
    for (SceneMean* mean : {&best, &near, &extra}) mean->NextScene();
  }
  void Add(const Options& options, std::span<const double> preference) {
    const double top = *std::max_element(preference.begin(), preference.end());
    const double ideal = options.best();
    int chosen = 0;
    int right = 0;
    int close = 0;
    double lost = 0.0;
    for (std::size_t i = 0; i < preference.size(); ++i) {
      if (preference[i] < top) continue;
      const double less = ideal - options.truth[i];
      ++chosen;
      right += less <= kRounding ? 1 : 0;
      close += less <= kMetre + kRounding ? 1 : 0;
      lost += less / kMetre;
    }
    best.Add(static_cast<double>(right) / chosen);
    near.Add(static_cast<double>(close) / chosen);
    extra.Add(lost / chosen);
  }
  ChoiceFigures Figures(std::uint64_t seed) const {
    return {best.Figure(seed), near.Figure(seed), extra.Figure(seed)};
  }
};

/// Everything that is summed up over pairs.
class ScoreSums {
 public:
  void NextScene() {
    for (SceneMean* mean : {&error_, &error_explorable_, &error_of_mean_, &in_place_, &for_goal_}) {
      mean->NextScene();
    }
    for (ChoiceSums* sums : {&model_, &chance_, &reach_, &straight_}) sums->NextScene();
  }

  /// One goal from everywhere in its scene.
  void AddGoal(const SceneCases& cases, int goal, double mean_truth) {
    Options all;
    for (int source = 0; source < cases.count(); ++source) {
      if (source == goal || cases.samples.pair(source, goal).same_node != 0) continue;
      ++pairs_;
      AddErrors(cases, source, goal);
      const Options options = OptionsOf(cases, source, goal);
      for (std::size_t i = 0; i < options.truth.size(); ++i) {
        error_explorable_.Add(std::abs(options.said[i] - options.truth[i]));
        error_of_mean_.Add(std::abs(mean_truth - options.truth[i]));
      }
      all.truth.insert(all.truth.end(), options.truth.begin(), options.truth.end());
      all.said.insert(all.said.end(), options.said.begin(), options.said.end());
      if (options.HasChoice()) AddChoice(options);
    }
    if (all.HasChoice()) for_goal_.Add(RankCorrelation(all.said, all.truth));
    overall_.truth.insert(overall_.truth.end(), all.truth.begin(), all.truth.end());
    overall_.said.insert(overall_.said.end(), all.said.begin(), all.said.end());
  }

  ScoreFigures Figures(std::uint64_t seed) const {
    ScoreFigures figures;
    figures.pairs = pairs_;
    figures.error = error_.Figure(seed);
    figures.error_explorable = error_explorable_.Figure(seed);
    figures.error_of_mean = error_of_mean_.Figure(seed);
    figures.rank_in_place = in_place_.Figure(seed);
    figures.rank_for_goal = for_goal_.Figure(seed);
    figures.rank_overall = RankCorrelation(overall_.said, overall_.truth);
    figures.model = model_.Figures(seed);
    figures.chance = chance_.Figures(seed);
    figures.reach = reach_.Figures(seed);
    figures.straight = straight_.Figures(seed);
    return figures;
  }

 private:
  void AddErrors(const SceneCases& cases, int source, int goal) {
    const PairLabel& truth = cases.samples.pair(source, goal);
    const PerDirection& said = cases.prediction(source, goal).score;
    for (int i = 0; i < agent::kDirections; ++i) {
      const double off = double{said[static_cast<std::size_t>(i)]} - double{truth.far_score(i)};
      error_.Add(std::abs(off));
    }
  }

  void AddChoice(const Options& options) {
    in_place_.Add(RankCorrelation(options.said, options.truth));
    model_.Add(options, options.said);
    chance_.Add(options, std::vector<double>(options.truth.size(), 0.0));
    reach_.Add(options, options.reach);
    straight_.Add(options, options.closeness);
  }

  std::int64_t pairs_ = 0;
  SceneMean error_;
  SceneMean error_explorable_;
  SceneMean error_of_mean_;
  SceneMean in_place_;
  SceneMean for_goal_;
  Options overall_;
  ChoiceSums model_;
  ChoiceSums chance_;
  ChoiceSums reach_;
  ChoiceSums straight_;
};

/// Of explorable directions of pairs of two nodes.
double MeanTruth(std::span<const SceneCases> scenes) {
  double sum = 0.0;
  double count = 0.0;
  for (const SceneCases& cases : scenes) {
    ForEachPair(cases, [&](int source, int goal) {
      if (cases.samples.pair(source, goal).same_node != 0) return;
      const Options options = OptionsOf(cases, source, goal);
      sum = std::accumulate(options.truth.begin(), options.truth.end(), sum);
      count += static_cast<double>(options.truth.size());
    });
  }
  return count > 0.0 ? sum / count : 0.0;
}

}  // namespace

ScoreFigures MeasureScores(std::span<const SceneCases> scenes, std::uint64_t seed) {
  const double mean_truth = MeanTruth(scenes);
  ScoreSums sums;
  for (const SceneCases& cases : scenes) {
    sums.NextScene();
    for (int goal = 0; goal < cases.count(); ++goal) sums.AddGoal(cases, goal, mean_truth);
  }
  return sums.Figures(seed);
}

}  // namespace bulletnav::bench
