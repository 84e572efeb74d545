// SPDX-License-Identifier: MIT
#include "benchmark/play/vector_environment.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include <fmt/core.h>

#include "sim/base/error.h"
#include "sim/math/rng.h"

namespace bulletnav::bench {
namespace {

constexpr std::size_t kColorChannels = 3;

/// Which episode stands at a place of a pass.
std::size_t EpisodeAt(const VectorSpec& spec, std::uint64_t pass, std::size_t place) {
  if (!spec.shuffle) return place;
  std::vector<std::size_t> order(spec.episodes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  sim::Rng(spec.seed, "order of episodes").Fork("pass", pass).Shuffle(order);
  return order[place];
}

std::vector<int> AllOf(int lanes) {
  std::vector<int> all(static_cast<std::size_t>(lanes));
  std::iota(all.begin(), all.end(), 0);
  return all;
}

}  // namespace

VectorEnvironment::VectorEnvironment(VectorSpec spec, WorldSource worlds)
    : spec_(std::move(spec)), worlds_(std::move(worlds)) {
  Require(spec_.lanes >= 1, "lanes must be at least 1");
  Require(!spec_.episodes.empty(), "there are no episodes");
  const auto lanes = static_cast<std::size_t>(spec_.lanes);
  truths_.resize(lanes);
  std::vector<GroundTruth*> truths;
  truths.reserve(lanes);
  for (GroundTruth& truth : truths_) truths.push_back(&truth);
  environment_ = std::make_unique<Environment>(spec_.task, std::move(truths), spec_.threads);
  arrays_ = environment_->arrays();
  for (std::size_t i = 0; i < arrays_.size(); ++i) memory_.push_back(environment_->memory(i));
  const sim::PanoramaSpec& panorama = spec_.task.panorama;
  if (spec_.task.color) {
    goal_color_.resize(kColorChannels * panorama.pixels() * lanes);
    arrays_.push_back({"goal.color",
                       {panorama.rows, panorama.cols, static_cast<int>(kColorChannels)},
                       sim::Element::kUint8,
                       "display value"});
    memory_.push_back(std::as_bytes(std::span(goal_color_)));
  }
  if (spec_.task.depth) {
    goal_depth_.resize(panorama.pixels() * lanes);
    arrays_.push_back({"goal.depth", {panorama.rows, panorama.cols}, sim::Element::kFloat32, "m"});
    memory_.push_back(std::as_bytes(std::span(goal_depth_)));
  }
  next_.resize(lanes);
  playing_.resize(lanes);
  rewards_.resize(lanes);
  terminated_.resize(lanes);
  truncated_.resize(lanes);
}

VectorEnvironment::~VectorEnvironment() = default;

void VectorEnvironment::Require(bool is_right, const std::string& what) const {
  if (!is_right) throw sim::Error("VectorEnvironment: " + what);
}

const Episode& VectorEnvironment::episode(int lane) const {
  Require(is_begun_, "call reset first");
  return playing_.at(static_cast<std::size_t>(lane));
}

const GroundTruth& VectorEnvironment::truth(int lane) const {
  Require(is_begun_, "call reset first");
  return truths_.at(static_cast<std::size_t>(lane));
}

/// Puts a lane's next episode into it.
void VectorEnvironment::Start(int lane) {
  const auto i = static_cast<std::size_t>(lane);
  const std::uint64_t number = next_[i];
  next_[i] += static_cast<std::uint64_t>(spec_.lanes);
  const std::uint64_t pass = number / spec_.episodes.size();
  playing_[i] = spec_.episodes[EpisodeAt(spec_, pass, number % spec_.episodes.size())];
  EpisodeTask task;
  task.episode = playing_[i];
  // Other noise each time that the episode comes round.
  task.key = {"", "", "", sim::MixSeed(spec_.seed, pass), playing_[i].scene, playing_[i].id};
  task.scene_file = playing_[i].scene;
  environment_->Reset(lane, std::move(task), worlds_(playing_[i].scene));
}

void VectorEnvironment::Reset(std::uint64_t seed) {
  spec_.seed = seed;
  std::iota(next_.begin(), next_.end(), std::uint64_t{0});
  for (const int lane : AllOf(spec_.lanes)) Start(lane);
  is_begun_ = true;
  std::fill(rewards_.begin(), rewards_.end(), 0.0);
  std::fill(terminated_.begin(), terminated_.end(), std::uint8_t{0});
  std::fill(truncated_.begin(), truncated_.end(), std::uint8_t{0});
  finished_.clear();
  TakeGoals();
  environment_->Observe(AllOf(spec_.lanes));
}

void VectorEnvironment::RequireLanes(std::span<const int> lanes) const {
  int last = -1;
  for (const int lane : lanes) {
    Require(lane >= 0 && lane < spec_.lanes, fmt::format("there is no lane {}", lane));
    Require(lane > last, "lanes must rise");
    last = lane;
  }
}

void VectorEnvironment::ResetLanes(std::span<const int> lanes) {
  Require(is_begun_, "call reset first");
  RequireLanes(lanes);
  for (const int lane : lanes) Start(lane);
  TakeGoals();
  environment_->Observe(lanes);
}

void VectorEnvironment::Step(std::span<const sim::Action> actions) {
  Step(AllOf(spec_.lanes), actions);
}

void VectorEnvironment::Step(std::span<const int> lanes, std::span<const sim::Action> actions) {
  Require(is_begun_, "call reset first");
  RequireLanes(lanes);
  Require(actions.size() == lanes.size(),
          fmt::format("got {} actions for {} lanes", actions.size(), lanes.size()));
  std::vector<int> moving;
  std::vector<sim::Action> taken;
  std::vector<int> ended;
  for (std::size_t i = 0; i < lanes.size(); ++i) {
    if (environment_->is_over(lanes[i])) {
      ended.push_back(lanes[i]);
    } else {
      moving.push_back(lanes[i]);
      taken.push_back(actions[i]);
    }
  }
  Require(ended.empty() || spec_.autoreset != Autoreset::kNever,
          fmt::format("the episode of lane {} is over; reset it first",
                      ended.empty() ? 0 : ended.front()));
  for (const int lane : lanes) {
    const auto i = static_cast<std::size_t>(lane);
    rewards_[i] = 0.0;
    terminated_[i] = truncated_[i] = 0;
  }
  finished_.clear();
  const std::span<const StepOutcome> outcomes = environment_->StepAndObserve(moving, taken);
  std::vector<int> begun = std::move(ended);
  for (const int lane : begun) Start(lane);
  for (std::size_t i = 0; i < moving.size(); ++i) {
    if (Note(moving[i], outcomes[i])) begun.push_back(moving[i]);
  }
  TakeGoals();
  std::sort(begun.begin(), begun.end());
  environment_->Observe(begun);
}

/// What a step of a lane came to. Returns whether its next episode has begun.
bool VectorEnvironment::Note(int lane, const StepOutcome& outcome) {
  const auto i = static_cast<std::size_t>(lane);
  rewards_[i] = outcome.reward;
  if (!environment_->is_over(lane)) return false;
  terminated_[i] = outcome.truncated ? 0 : 1;
  truncated_[i] = outcome.truncated ? 1 : 0;
  finished_.push_back({lane, environment_->Finish(lane, {}).result});
  if (spec_.autoreset != Autoreset::kSameStep) return false;
  Start(lane);
  return true;
}

void VectorEnvironment::TakeGoals() {
  const std::size_t pixels = spec_.task.panorama.pixels();
  for (const int lane : AllOf(spec_.lanes)) {
    if (!environment_->TakeNewGoal(lane)) continue;
    const agent::Panorama goal = environment_->goal(lane);
    const std::size_t first = static_cast<std::size_t>(lane) * pixels;
    std::copy(goal.color.begin(), goal.color.end(),
              goal_color_.begin() + static_cast<std::ptrdiff_t>(kColorChannels * first));
    std::copy(goal.depth.begin(), goal.depth.end(),
              goal_depth_.begin() + static_cast<std::ptrdiff_t>(first));
  }
}

}  // namespace bulletnav::bench
