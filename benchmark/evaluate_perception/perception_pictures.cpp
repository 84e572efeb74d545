// SPDX-License-Identifier: MIT
#include "benchmark/evaluate_perception/perception_pictures.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <fmt/core.h>

#include "benchmark/evaluate_perception/example_figures.h"
#include "sim/math/rng.h"

namespace bulletnav::bench {
namespace {

constexpr std::size_t kSources = 4;    // of a picture of choices
constexpr double kLeastSpread = 0.05;  // of scores, 1 m, for there to be a choice

std::vector<int> Shuffled(int count, sim::Rng rng) {
  std::vector<int> numbers(static_cast<std::size_t>(count));
  std::iota(numbers.begin(), numbers.end(), 0);
  rng.Shuffle(numbers);
  return numbers;
}

/// Draws the lots for one scene's examples.
class Lots {
 public:
  Lots(const SceneCases& cases, const sim::Rng& rng) : cases_(cases), rng_(rng) {}

  int Place() const { return Shuffled(cases_.count(), rng_.Fork("place")).front(); }

  /// A pair of one node; {0, 0} if there is none.
  std::pair<int, int> NearPair() const {
    const std::vector<int> goals = Shuffled(cases_.count(), rng_.Fork("near goal"));
    for (const int source : Shuffled(cases_.count(), rng_.Fork("near"))) {
      const auto goal = std::find_if(goals.begin(), goals.end(), [&](int other) {
        return source != other && cases_.samples.pair(source, other).same_node != 0;
      });
      if (goal != goals.end()) return {source, *goal};
    }
    return {0, 0};
  }

  /// A place and two goals whose best directions differ.
  std::pair<int, std::vector<int>> TwoGoals() const {
    for (const int source : Shuffled(cases_.count(), rng_.Fork("source"))) {
      std::vector<int> goals = TwoGoalsFrom(source);
      if (goals.size() == 2) return {source, std::move(goals)};
    }
    return {0, {}};
  }

  /// A goal and places with a choice of ways to it, none within sight of another.
  std::pair<std::vector<int>, int> Ways() const {
    for (const int goal : Shuffled(cases_.count(), rng_.Fork("goal"))) {
      std::vector<int> sources = WaysTo(goal);
      if (sources.size() == kSources) return {std::move(sources), goal};
    }
    return {{}, 0};
  }

 private:
  /// At most two.
  std::vector<int> TwoGoalsFrom(int source) const {
    std::vector<int> goals;
    for (const int goal : Shuffled(cases_.count(), rng_.Fork("goals"))) {
      if (goals.size() == 2) break;
      if (!HasChoice(source, goal)) continue;
      if (goals.empty() || Best(source, goal) != Best(source, goals.front())) {
        goals.push_back(goal);
      }
    }
    return goals;
  }

  /// At most kSources.
  std::vector<int> WaysTo(int goal) const {
    std::vector<int> sources;
    for (const int source : Shuffled(cases_.count(), rng_.Fork("sources"))) {
      if (sources.size() == kSources) break;
      const bool is_new = std::none_of(sources.begin(), sources.end(), [&](int other) {
        return cases_.samples.pair(source, other).same_node != 0;
      });
      if (is_new && HasChoice(source, goal)) sources.push_back(source);
    }
    return sources;
  }

  int Best(int source, int goal) const { return ChoiceOf(cases_, source, goal).best; }

  bool HasChoice(int source, int goal) const {
    const PairLabel& truth = cases_.samples.pair(source, goal);
    if (source == goal || truth.same_node != 0) return false;
    float least = 1.0f;
    float most = 0.0f;
    for (int i = 0; i < agent::kDirections; ++i) {
      if (!cases_.samples.IsExplorable(source, i)) continue;
      least = std::min(least, truth.far_score(i));
      most = std::max(most, truth.far_score(i));
    }
    return double{most - least} > kLeastSpread;
  }

  const SceneCases& cases_;
  sim::Rng rng_;
};

}  // namespace

void DrawExamples(std::span<const SceneCases> scenes, const PerceptionConfig& config,
                  const std::filesystem::path& folder, const std::function<void()>& on_example) {
  const sim::Rng rng(config.seed, "perception pictures");
  const std::vector<int> order = Shuffled(static_cast<int>(scenes.size()), rng.Fork("scenes"));
  for (int number = 0; number < config.pictures; ++number) {
    const auto turn = static_cast<std::size_t>(number) % order.size();
    const SceneCases& cases = scenes[static_cast<std::size_t>(order[turn])];
    ExampleScene scene(cases, config.data);
    const Lots lots(cases, rng.Fork("example", static_cast<std::uint64_t>(number)));
    const auto write = [&](const char* kind, const Figure& figure) {
      WriteFigure(figure, folder / fmt::format("{}-{}", kind, number + 1));
    };
    write("explorable", ExplorableFigure(&scene, lots.Place(), config.explorable));
    const auto [near_source, near_goal] = lots.NearPair();
    if (near_source != near_goal) {
      write("relative_pose", RelativePoseFigure(&scene, near_source, near_goal));
    }
    const auto [source, goals] = lots.TwoGoals();
    if (!goals.empty()) write("scores", ScoresFigure(&scene, source, goals));
    const auto [sources, goal] = lots.Ways();
    if (!sources.empty()) write("choices", ChoicesFigure(&scene, sources, goal));
    if (on_example) on_example();
  }
}

}  // namespace bulletnav::bench
