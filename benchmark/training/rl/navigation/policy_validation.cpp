// SPDX-License-Identifier: MIT
#include "benchmark/training/rl/navigation/policy_validation.h"

#include <algorithm>
#include <array>
#include <utility>

#include "agent/policy/policy_agent.h"
#include "benchmark/privileged/shortest_path.h"

namespace bulletnav::bench {

PolicyValidation::PolicyValidation(NavigationScenes* scenes, const Task& task, int episodes)
    : task_(task) {
  for (int i = 0; i < episodes; ++i) {
    episodes_.push_back(scenes->DrawInTurn(static_cast<std::uint64_t>(i)));
  }
}

PolicyValidation::Result PolicyValidation::Play(const NavigationScenes::Drawn& drawn,
                                                bool with_depth, const PolicyMaker& make) const {
  Task task = task_;
  task.depth = with_depth;
  task.reward.reset();
  GroundTruth truth;
  Environment environment(task, {&truth}, 1);
  agent::PolicyAgent agent({}, make());
  constexpr int kLane = 0;
  environment.Reset(kLane, drawn.episode, drawn.world);
  while (!environment.is_over(kLane)) {
    if (environment.TakeNewGoal(kLane)) {
      agent.Reset(environment.goal(kLane), environment.agent_seed(kLane));
    }
    environment.Observe({&kLane, 1});
    const std::array action = {agent.Act(environment.observation(kLane))};
    environment.Step({&kLane, 1}, action);
  }
  const EpisodeResult result = environment.Finish(kLane, {}).result;
  const GoalMetrics& goal = result.goals.back();
  const double steps = goal.Value("steps");
  return {*drawn.episode.episode.difficulty, goal.success() ? 1.0 : 0.0, goal.Value("spl"), steps,
          steps < task.max_steps ? 1.0 : 0.0};
}

agent::PolicyCalibration PolicyValidation::Calibration(int rows, bool with_depth) const {
  constexpr std::size_t kEpisodes = 24;
  constexpr int kSteps = 12;
  constexpr int kLane = 0;
  agent::PolicyPictures pictures(rows);
  std::vector<torch::Tensor> seen, goals, numbers;
  const auto shown = [&](const agent::Panorama& panorama) {
    torch::Tensor bytes =
        torch::empty({static_cast<std::int64_t>(pictures.bytes())}, torch::kUInt8);
    pictures.Write(panorama, {bytes.data_ptr<std::uint8_t>(), pictures.bytes()});
    return bytes;
  };
  Task task = task_;
  task.depth = with_depth;
  task.reward.reset();
  for (std::size_t i = 0; i < std::min(kEpisodes, episodes_.size()); ++i) {
    GroundTruth truth;
    Environment environment(task, {&truth}, 1);
    environment.Reset(kLane, episodes_[i].episode, episodes_[i].world);
    ShortestPathAgent teacher(ShortestPathAgent::Config{});
    teacher.Reset(truth);
    std::optional<sim::Action> last;
    for (int step = 0; step < kSteps && !environment.is_over(kLane); ++step) {
      environment.Observe({&kLane, 1});
      const agent::Observation observation = environment.observation(kLane);
      seen.push_back(shown(observation.panorama));
      goals.push_back(shown(environment.goal(kLane)));
      numbers.push_back(torch::empty({agent::kPolicyNumbers}));
      agent::WritePolicyNumbers(observation, last, task.max_steps,
                                {numbers.back().data_ptr<float>(), agent::kPolicyNumbers});
      last = teacher.Act(truth);
      environment.Step({&kLane, 1}, std::array{*last});
    }
  }
  return {at::stack(seen), at::stack(goals), at::stack(numbers)};
}

void PolicyValidation::Measure(const PolicyMaker& make, bool with_depth, const std::string& prefix,
                               sim::WorkerPool* pool, Measures* measures) const {
  std::vector<Result> results(episodes_.size());
  pool->ForEach(static_cast<int>(episodes_.size()), [&](int i, int) {
    const auto at = static_cast<std::size_t>(i);
    results[at] = Play(episodes_[at], with_depth, make);
  });
  const auto mean = [&](double Result::*of, std::optional<Difficulty> kind) {
    double sum = 0.0;
    double count = 0.0;
    for (const Result& result : results) {
      if (kind && result.kind != *kind) continue;
      sum += result.*of;
      count += 1.0;
    }
    return count > 0.0 ? sum / count : 0.0;
  };
  (*measures)(prefix + "success", mean(&Result::success, std::nullopt));
  (*measures)(prefix + "spl", mean(&Result::spl, std::nullopt));
  for (const Difficulty kind : {Difficulty::kEasy, Difficulty::kMedium, Difficulty::kHard}) {
    (*measures)(prefix + "success_" + std::string(DifficultyName(kind)),
                mean(&Result::success, kind));
  }
  (*measures)(prefix + "steps", mean(&Result::steps, std::nullopt));
  (*measures)(prefix + "stopped", mean(&Result::stopped, std::nullopt));
}

}  // namespace bulletnav::bench
