// SPDX-License-Identifier: MIT
#include "benchmark/training/rl/navigation/navigation_lanes.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "sim/base/check.h"

namespace bulletnav::bench {
namespace {

std::vector<GroundTruth*> PointersTo(std::vector<GroundTruth>* truths) {
  std::vector<GroundTruth*> pointers;
  pointers.reserve(truths->size());
  for (GroundTruth& truth : *truths) pointers.push_back(&truth);
  return pointers;
}

}  // namespace

NavigationLanes::NavigationLanes(const NavigationSpec& spec, NavigationScenes* scenes,
                                 sim::WorkerPool* pool)
    : spec_(spec),
      scenes_(scenes),
      pool_(pool),
      truths_(static_cast<std::size_t>(spec.lanes)),
      lanes_(truths_.size()),
      environment_(std::make_unique<Environment>(spec.task, PointersTo(&truths_), pool->workers())),
      all_(truths_.size()) {
  std::iota(all_.begin(), all_.end(), 0);
  for (Lane& lane : lanes_) {
    lane.pictures = std::make_unique<agent::PolicyPictures>(spec.rows);
    if (spec.teaches)
      lane.teacher = std::make_unique<ShortestPathAgent>(ShortestPathAgent::Config{});
  }
}

std::size_t NavigationLanes::picture_bytes() const {
  return lanes_.front().pictures->bytes();
}

void NavigationLanes::Begin(int lane, std::uint64_t episode) {
  Lane& own = lanes_[static_cast<std::size_t>(lane)];
  own.episode = episode;
  own.taken.clear();
  own.lesson.reset();
  NavigationScenes::Drawn drawn = scenes_->Draw(lane, episode);
  environment_->Reset(lane, std::move(drawn.episode), std::move(drawn.world));
  if (own.teacher) own.teacher->Reset(truths_[static_cast<std::size_t>(lane)]);
}

agent::Panorama NavigationLanes::Shown(int lane, const agent::Panorama& panorama) const {
  const bool has_depth =
      spec_.setting == LaneSetting::kRgbd || (spec_.setting == LaneSetting::kBoth && lane % 2 == 0);
  return has_depth ? panorama : agent::Panorama{panorama.color, {}};
}

void NavigationLanes::Observe(std::span<float> numbers, std::span<std::uint8_t> pictures) {
  environment_->Observe(all_);
  pool_->ForEach(lanes(), [&](int lane, int) {
    const auto i = static_cast<std::size_t>(lane);
    Lane& own = lanes_[i];
    const agent::Observation seen = environment_->observation(lane);
    const auto last = own.taken.empty() ? std::nullopt : std::optional(own.taken.back());
    agent::WritePolicyNumbers(seen, last, spec_.task.max_steps,
                              numbers.subspan(i * agent::kPolicyNumbers, agent::kPolicyNumbers));
    own.pictures->Write(Shown(lane, seen.panorama),
                        pictures.subspan(i * picture_bytes(), picture_bytes()));
  });
}

void NavigationLanes::ShowGoal(int lane, std::span<std::uint8_t> picture) const {
  const auto i = static_cast<std::size_t>(lane);
  lanes_[i].pictures->Write(Shown(lane, environment_->goal(lane)), picture);
}

void NavigationLanes::AskTeacher(int lane) {
  const auto i = static_cast<std::size_t>(lane);
  if (!lanes_[i].lesson) lanes_[i].lesson = lanes_[i].teacher->Act(truths_[i]);
}

bool NavigationLanes::Teach(std::span<int> actions) {
  if (!spec_.teaches) return false;
  pool_->ForEach(lanes(), [&](int lane, int) {
    AskTeacher(lane);
    const auto i = static_cast<std::size_t>(lane);
    actions[i] = static_cast<int>(*lanes_[i].lesson);
  });
  return true;
}

LaneOutcome NavigationLanes::OutcomeOf(int lane, const StepOutcome& step) const {
  LaneOutcome outcome{step.reward, step.terminated, step.truncated, 0.0, false};
  if (!environment_->is_over(lane)) return outcome;
  const EpisodeResult result = environment_->Finish(lane, {}).result;
  outcome.score = result.goals.back().Value("spl");
  outcome.success = result.goals.back().success();
  return outcome;
}

void NavigationLanes::Step(std::span<const int> actions, std::span<LaneOutcome> outcomes) {
  std::vector<sim::Action> chosen;
  chosen.reserve(actions.size());
  for (const int action : actions)
    chosen.push_back(sim::kAllActions.at(static_cast<std::size_t>(action)));
  const std::span<const StepOutcome> came = environment_->Step(all_, chosen);
  for (std::size_t i = 0; i < lanes_.size(); ++i) {
    outcomes[i] = OutcomeOf(static_cast<int>(i), came[i]);
    lanes_[i].taken.push_back(chosen[i]);
    lanes_[i].lesson.reset();
  }
}

std::vector<float> NavigationLanes::State() const {
  const auto most = static_cast<std::size_t>(spec_.task.max_steps);
  std::vector<float> state;
  state.reserve(lanes_.size() * (most + 2));
  for (const Lane& lane : lanes_) {
    state.push_back(static_cast<float>(lane.episode));
    state.push_back(static_cast<float>(lane.taken.size()));
    for (std::size_t i = 0; i < most; ++i) {
      state.push_back(i < lane.taken.size() ? static_cast<float>(lane.taken[i]) : 0.0F);
    }
  }
  return state;
}

void NavigationLanes::SetState(std::span<const float> state) {
  const auto most = static_cast<std::size_t>(spec_.task.max_steps);
  BULLETNAV_CHECK_EQ(state.size(), lanes_.size() * (most + 2));
  for (int lane = 0; lane < lanes(); ++lane) {
    const auto own = state.subspan(static_cast<std::size_t>(lane) * (most + 2), most + 2);
    Begin(lane, static_cast<std::uint64_t>(own[0]));
    for (const float taken : own.subspan(2, static_cast<std::size_t>(own[1]))) {
      const std::array action = {sim::kAllActions.at(static_cast<std::size_t>(taken))};
      if (spec_.teaches) AskTeacher(lane);  // it remembers, too
      environment_->Step({&lane, 1}, action);
      lanes_[static_cast<std::size_t>(lane)].taken.push_back(action[0]);
      lanes_[static_cast<std::size_t>(lane)].lesson.reset();
    }
  }
}

}  // namespace bulletnav::bench
