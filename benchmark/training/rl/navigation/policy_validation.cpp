// SPDX-License-Identifier: MIT
#include "benchmark/training/rl/navigation/policy_validation.h"

#include <algorithm>
#include <array>
#include <utility>

#include "agent/policy/policy_agent.h"
#include "benchmark/privileged/shortest_path.h"
#include "sim/base/check.h"

namespace bulletnav::bench {

PolicyValidation::PolicyValidation(NavigationScenes* scenes, const Task& task, int episodes)
    : task_(task) {
  for (int i = 0; i < episodes; ++i) {
    episodes_.push_back(scenes->DrawInTurn(static_cast<std::uint64_t>(i)));
  }
}

/// What a panorama showed, kept.
class PolicyValidation::Picture {
 public:
  explicit Picture(const agent::Panorama& seen)
      : color_(seen.color.begin(), seen.color.end()),
        depth_(seen.depth.begin(), seen.depth.end()) {}
  agent::Panorama view() const { return {color_, depth_}; }
  void Blank() {
    std::fill(color_.begin(), color_.end(), std::uint8_t{0});
    std::fill(depth_.begin(), depth_.end(), 0.0f);
  }
  /// Each pixel of rows of `cols` becomes a square of factor x factor.
  void Enlarge(int cols, int factor) {
    Enlarge<3>(cols, factor, &color_);
    Enlarge<1>(cols, factor, &depth_);
  }

 private:
  template <int kChannels, class T>
  static void Enlarge(int cols, int factor, std::vector<T>* pixels) {
    const std::size_t row = std::size_t{kChannels} * static_cast<std::size_t>(cols);
    std::vector<T> large;
    large.reserve(pixels->size() * static_cast<std::size_t>(factor) *
                  static_cast<std::size_t>(factor));
    for (std::size_t first = 0; first < pixels->size(); first += row) {
      for (int copy = 0; copy < factor; ++copy) {
        for (std::size_t at = first; at < first + row; at += kChannels) {
          const auto pixel = pixels->begin() + static_cast<std::ptrdiff_t>(at);
          for (int i = 0; i < factor; ++i) large.insert(large.end(), pixel, pixel + kChannels);
        }
      }
    }
    *pixels = std::move(large);
  }

  std::vector<std::uint8_t> color_;
  std::vector<float> depth_;
};

/// A panorama as the policy is to see it; the size is the task's.
PolicyValidation::Picture PolicyValidation::Shown(const agent::Panorama& panorama,
                                                  const Way& way) const {
  Picture picture(panorama);
  if (way.blank_images) picture.Blank();
  if (way.direct_rows > 0) {
    const int factor = task_.panorama.rows / way.direct_rows;
    picture.Enlarge(task_.panorama.cols / factor, factor);
  }
  return picture;
}

PolicyValidation::Picture PolicyValidation::GoalOf(std::size_t number, const Task& task) const {
  GroundTruth truth;
  Environment environment(task, {&truth}, 1);
  environment.Reset(0, episodes_[number].episode, episodes_[number].world);
  return Picture(environment.goal(0));
}

PolicyValidation::Result PolicyValidation::Play(std::size_t number, const Way& way,
                                                const PolicyMaker& make) const {
  const NavigationScenes::Drawn& drawn = episodes_[number];
  Task task = task_;
  task.depth = way.with_depth;
  task.reward.reset();
  const agent::Rig rig = RigOf(task);
  if (way.direct_rows > 0) {
    BULLETNAV_CHECK(task.panorama.rows % way.direct_rows == 0);
    task = Drawn(task, DrawMode::kDirect, way.direct_rows);
  }
  GroundTruth truth;
  Environment environment(task, {&truth}, 1);
  agent::PolicyAgent agent(way.agent, make(), rig);
  constexpr int kLane = 0;
  environment.Reset(kLane, drawn.episode, drawn.world);
  Picture drawn_goal(environment.goal(kLane));
  if (way.shuffle_goals) drawn_goal = GoalOf((number + 1) % episodes_.size(), task);
  const Picture goal = Shown(drawn_goal.view(), way);
  agent.Reset(goal.view(), environment.agent_seed(kLane));
  const bool is_changed = way.blank_images || way.direct_rows > 0;
  while (!environment.is_over(kLane)) {
    environment.Observe({&kLane, 1});
    agent::Observation seen = environment.observation(kLane);
    std::optional<Picture> shown;
    if (is_changed) seen.panorama = shown.emplace(Shown(seen.panorama, way)).view();
    const std::array action = {agent.Act(seen)};
    environment.Step({&kLane, 1}, action);
  }
  const EpisodeResult result = environment.Finish(kLane, {}).result;
  const GoalMetrics& metrics = result.goals.back();
  const double steps = metrics.Value("steps");
  return {*drawn.episode.episode.difficulty, metrics.success() ? 1.0 : 0.0, metrics.Value("spl"),
          steps, steps < task.max_steps ? 1.0 : 0.0};
}

/// Each process plays every so many; the numbers of all come together.
std::vector<PolicyValidation::Result> PolicyValidation::PlayAll(const Way& way,
                                                                const PolicyMaker& make) const {
  constexpr std::size_t kNumbers = 4;
  const std::size_t size = way.peers == nullptr ? 1 : static_cast<std::size_t>(way.peers->size());
  const std::size_t rank = way.peers == nullptr ? 0 : static_cast<std::size_t>(way.peers->rank());
  std::vector<double> numbers(kNumbers * episodes_.size());
  std::vector<std::size_t> own;
  for (std::size_t i = rank; i < episodes_.size(); i += size) own.push_back(i);
  way.pool->ForEach(static_cast<int>(own.size()), [&](int i, int) {
    const std::size_t number = own[static_cast<std::size_t>(i)];
    const Result result = Play(number, way, make);
    const std::array<double, kNumbers> all = {result.success, result.spl, result.steps,
                                              result.stopped};
    std::copy(all.begin(), all.end(),
              numbers.begin() + static_cast<std::ptrdiff_t>(kNumbers * number));
  });
  if (way.peers != nullptr) numbers = way.peers->Gather(numbers);
  std::vector<Result> results;
  for (std::size_t i = 0; i < episodes_.size(); ++i) {
    const double* n = &numbers[kNumbers * (i % size * episodes_.size() + i)];
    results.push_back({*episodes_[i].episode.episode.difficulty, n[0], n[1], n[2], n[3]});
  }
  return results;
}

agent::PolicyCalibration PolicyValidation::Calibration(const agent::PolicyConfig& config,
                                                       LaneSetting setting) const {
  if (setting == LaneSetting::kBoth) {
    const agent::PolicyCalibration color = Calibration(config, LaneSetting::kRgb);
    const agent::PolicyCalibration depth = Calibration(config, LaneSetting::kRgbd);
    return {at::cat({color.pictures, depth.pictures}),
            at::cat({color.goal_pictures, depth.goal_pictures}),
            at::cat({color.numbers, depth.numbers})};
  }
  constexpr std::size_t kEpisodes = 24;
  constexpr int kSteps = 12;
  constexpr int kLane = 0;
  agent::PolicyPictures pictures(config.rows);
  std::vector<torch::Tensor> seen, goals, numbers;
  Task task = task_;
  task.depth = setting == LaneSetting::kRgbd;
  task.reward.reset();
  std::optional<agent::PolicyMap> map;
  if (config.map) map.emplace(RigOf(task));
  const auto shown = [&](const agent::Panorama& panorama) {
    const std::size_t size = pictures.bytes();
    torch::Tensor bytes = torch::zeros(
        {static_cast<std::int64_t>(size + (map ? agent::kPolicyMapBytes : 0))}, torch::kUInt8);
    std::uint8_t* data = bytes.data_ptr<std::uint8_t>();
    pictures.Write(panorama, {data, size});
    if (map) std::copy(map->bytes().begin(), map->bytes().end(), data + size);
    return bytes;
  };
  for (std::size_t i = 0; i < std::min(kEpisodes, episodes_.size()); ++i) {
    GroundTruth truth;
    Environment environment(task, {&truth}, 1);
    environment.Reset(kLane, episodes_[i].episode, episodes_[i].world);
    ShortestPathAgent teacher(ShortestPathAgent::Config{});
    teacher.Reset(truth);
    if (map) map->Reset();
    std::optional<sim::Action> last;
    for (int step = 0; step < kSteps && !environment.is_over(kLane); ++step) {
      environment.Observe({&kLane, 1});
      const agent::Observation observation = environment.observation(kLane);
      if (map) map->See(observation);
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

void PolicyValidation::Measure(const PolicyMaker& make, const Way& way, Measures* measures) const {
  const std::vector<Result> results = PlayAll(way, make);
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
  (*measures)(way.prefix + "success", mean(&Result::success, std::nullopt));
  (*measures)(way.prefix + "spl", mean(&Result::spl, std::nullopt));
  for (const Difficulty kind : {Difficulty::kEasy, Difficulty::kMedium, Difficulty::kHard}) {
    (*measures)(way.prefix + "success_" + std::string(DifficultyName(kind)),
                mean(&Result::success, kind));
  }
  (*measures)(way.prefix + "steps", mean(&Result::steps, std::nullopt));
  (*measures)(way.prefix + "stopped", mean(&Result::stopped, std::nullopt));
}

}  // namespace bulletnav::bench
