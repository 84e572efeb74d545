// SPDX-License-Identifier: MIT
#include "benchmark/training/rl/navigation/navigation_lanes.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include <fmt/core.h>

#include "benchmark/base/memory.h"
#include "sim/base/check.h"

namespace bulletnav::bench {
namespace {

constexpr std::size_t kStateBefore = 3;  // numbers of a lane's state before its actions
constexpr int kTeachersPause = 25;       // actions
constexpr double kTeachersStray = 0.5;   // metres

std::vector<GroundTruth*> PointersTo(std::vector<GroundTruth>* truths) {
  std::vector<GroundTruth*> pointers;
  pointers.reserve(truths->size());
  for (GroundTruth& truth : *truths) pointers.push_back(&truth);
  return pointers;
}

/// Throws if so many bodies' panoramas do not fit into memory.
std::size_t LanesThatFit(const NavigationSpec& spec) {
  constexpr double kPixelBytes = 2 * (3 + sizeof(float));  // what is seen and the goal
  const double pixels =
      static_cast<double>(Drawn(spec.task, spec.draw, spec.rows).panorama.pixels());
  RequireMemory(spec.lanes * pixels * kPixelBytes, fmt::format("playing in {} lanes", spec.lanes),
                "take fewer lanes");
  return static_cast<std::size_t>(spec.lanes);
}

}  // namespace

Task Drawn(Task task, DrawMode draw, int rows) {
  if (draw == DrawMode::kAveraged) return task;
  task.panorama.rows = rows;
  task.panorama.cols = 4 * rows;
  return task;
}

agent::Rig RigOf(const Task& task) {
  agent::Rig rig;
  rig.panorama = task.panorama;
  rig.has_color = task.color;
  rig.has_depth = task.depth;
  rig.camera_height = task.body.camera_height;
  rig.body_radius = task.body.radius;
  rig.body_height = task.body.height;
  return rig;
}

NavigationLanes::Stage::Stage(const Task& task_in, int lanes, int threads)
    : task(task_in),
      truths(static_cast<std::size_t>(lanes)),
      environment(task, PointersTo(&truths), threads) {}

NavigationLanes::NavigationLanes(const NavigationSpec& spec, NavigationScenes* scenes,
                                 sim::WorkerPool* pool)
    : spec_(spec),
      scenes_(scenes),
      pool_(pool),
      draw_(spec.draw),
      lanes_(LanesThatFit(spec)),
      all_(lanes_.size()) {
  std::iota(all_.begin(), all_.end(), 0);
  for (const int lane : all_) {
    Enter(lane, draw_);
    if (!spec.teacher_stops) continue;
    at(lane).teacher = std::make_unique<ShortestPathAgent>(
        ShortestPathAgent::Config{.stop_distance = *spec.teacher_stops,
                                  .search_pause = kTeachersPause,
                                  .most_stray = kTeachersStray});
  }
}

NavigationLanes::Stage* NavigationLanes::StageOf(DrawMode draw) {
  std::unique_ptr<Stage>& stage = stages_.at(static_cast<std::size_t>(draw));
  if (!stage) {
    stage = std::make_unique<Stage>(Drawn(spec_.task, draw, spec_.rows), lanes(), pool_->workers());
  }
  return stage.get();
}

void NavigationLanes::Enter(int lane, DrawMode draw) {
  Lane& own = at(lane);
  Stage* stage = StageOf(draw);
  if (own.stage == stage) return;
  if (own.stage != nullptr) own.stage->environment.Clear(lane);
  own.stage = stage;
  own.draw = draw;
  own.pictures = std::make_unique<agent::PolicyPictures>(spec_.rows, stage->task.panorama.rows);
  if (spec_.map) own.map = std::make_unique<agent::PolicyMap>(RigOf(stage->task));
}

std::size_t NavigationLanes::picture_bytes() const {
  return lanes_.front().pictures->bytes() + (spec_.map ? agent::kPolicyMapBytes : 0);
}

void NavigationLanes::StartRollout(double done) {
  draw_ = done >= spec_.averaged_from ? DrawMode::kAveraged : spec_.draw;
}

void NavigationLanes::Begin(int lane, std::uint64_t episode) {
  Start(lane, episode, draw_);
}

void NavigationLanes::Start(int lane, std::uint64_t episode, DrawMode draw) {
  Enter(lane, draw);
  Lane& own = at(lane);
  own.episode = episode;
  own.taken.clear();
  own.lesson.reset();
  own.mapped.reset();
  if (own.map) own.map->Reset();
  NavigationScenes::Drawn drawn = scenes_->Draw(spec_.first_lane + lane, episode);
  own.stage->environment.Reset(lane, std::move(drawn.episode), std::move(drawn.world));
  if (own.teacher) own.teacher->Reset(own.stage->truths[static_cast<std::size_t>(lane)]);
}

agent::Panorama NavigationLanes::Shown(int lane, const agent::Panorama& panorama) const {
  const int number = spec_.first_lane + lane;
  const bool has_depth = spec_.setting == LaneSetting::kRgbd ||
                         (spec_.setting == LaneSetting::kBoth && number % 2 == 0);
  return has_depth ? panorama : agent::Panorama{panorama.color, {}};
}

/// Reads the sensors of some lanes, each where it is.
void NavigationLanes::Look(std::span<const int> lanes) {
  for (const std::unique_ptr<Stage>& stage : stages_) {
    if (!stage) continue;
    std::vector<int> here;
    std::copy_if(lanes.begin(), lanes.end(), std::back_inserter(here), [&](int lane) {
      return at(lane).stage == stage.get();
    });
    if (!here.empty()) stage->environment.Observe(here);
  }
}

/// Once a step, however often the same is looked at.
void NavigationLanes::Map(int lane) {
  Lane& own = at(lane);
  if (!own.map || own.mapped == own.taken.size()) return;
  own.map->See(own.stage->environment.observation(lane));
  own.mapped = own.taken.size();
}

void NavigationLanes::Observe(std::span<float> numbers, std::span<std::uint8_t> pictures) {
  Look(all_);
  pool_->ForEach(lanes(), [&](int lane, int) {
    const auto i = static_cast<std::size_t>(lane);
    Lane& own = lanes_[i];
    const agent::Observation seen = own.stage->environment.observation(lane);
    const auto last = own.taken.empty() ? std::nullopt : std::optional(own.taken.back());
    agent::WritePolicyNumbers(seen, last, spec_.task.max_steps,
                              numbers.subspan(i * agent::kPolicyNumbers, agent::kPolicyNumbers));
    const auto out = pictures.subspan(i * picture_bytes(), picture_bytes());
    own.pictures->Write(Shown(lane, seen.panorama), out.first(own.pictures->bytes()));
    if (!own.map) return;
    Map(lane);
    std::copy(own.map->bytes().begin(), own.map->bytes().end(),
              out.subspan(own.pictures->bytes()).begin());
  });
}

void NavigationLanes::ShowGoal(int lane, std::span<std::uint8_t> picture) const {
  const Lane& own = at(lane);
  const std::size_t bytes = own.pictures->bytes();
  own.pictures->Write(Shown(lane, own.stage->environment.goal(lane)), picture.first(bytes));
  std::fill(picture.begin() + static_cast<std::ptrdiff_t>(bytes), picture.end(), std::uint8_t{0});
}

void NavigationLanes::AskTeacher(int lane) {
  Lane& own = at(lane);
  if (own.lesson) return;
  const auto advice = own.teacher->Advise(own.stage->truths[static_cast<std::size_t>(lane)]);
  own.lesson = {static_cast<int>(advice.action), advice.leads};
}

bool NavigationLanes::Teach(std::span<Lesson> lessons) {
  if (!spec_.teacher_stops) return false;
  pool_->ForEach(lanes(), [&](int lane, int) {
    AskTeacher(lane);
    lessons[static_cast<std::size_t>(lane)] = *at(lane).lesson;
  });
  return true;
}

LaneOutcome NavigationLanes::OutcomeOf(int lane, const StepOutcome& step) const {
  const Environment& environment = at(lane).stage->environment;
  LaneOutcome outcome{step.reward, step.terminated || step.truncated, false, 0.0, false};
  if (!environment.is_over(lane)) return outcome;
  const EpisodeResult result = environment.Finish(lane, {}).result;
  outcome.score = result.goals.back().Value("spl");
  outcome.success = result.goals.back().success();
  return outcome;
}

/// An action for each of some lanes; `outcomes` in their order, or empty if nobody asks.
void NavigationLanes::Move(std::span<const int> lanes, std::span<const sim::Action> actions,
                           std::span<LaneOutcome> outcomes) {
  for (const std::unique_ptr<Stage>& stage : stages_) {
    if (!stage) continue;
    std::vector<int> here;
    std::vector<sim::Action> chosen;
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < lanes.size(); ++i) {
      if (at(lanes[i]).stage != stage.get()) continue;
      here.push_back(lanes[i]);
      chosen.push_back(actions[i]);
      places.push_back(i);
    }
    if (here.empty()) continue;
    const std::span<const StepOutcome> came = stage->environment.Step(here, chosen);
    for (std::size_t i = 0; i < here.size(); ++i) {
      if (!outcomes.empty()) outcomes[places[i]] = OutcomeOf(here[i], came[i]);
      at(here[i]).taken.push_back(chosen[i]);
      at(here[i]).lesson.reset();
    }
  }
}

void NavigationLanes::Step(std::span<const int> actions, std::span<LaneOutcome> outcomes) {
  std::vector<sim::Action> chosen;
  chosen.reserve(actions.size());
  for (const int action : actions)
    chosen.push_back(sim::kAllActions.at(static_cast<std::size_t>(action)));
  Move(all_, chosen, outcomes);
}

std::vector<float> NavigationLanes::State() const {
  const auto most = static_cast<std::size_t>(spec_.task.max_steps);
  std::vector<float> state;
  state.reserve(lanes_.size() * (most + kStateBefore));
  for (const Lane& lane : lanes_) {
    state.push_back(static_cast<float>(lane.episode));
    state.push_back(static_cast<float>(lane.draw));
    state.push_back(static_cast<float>(lane.taken.size()));
    for (std::size_t i = 0; i < most; ++i) {
      state.push_back(i < lane.taken.size() ? static_cast<float>(lane.taken[i]) : 0.0F);
    }
  }
  return state;
}

void NavigationLanes::SetState(std::span<const float> state) {
  const auto most = static_cast<std::size_t>(spec_.task.max_steps);
  const std::size_t size = most + kStateBefore;
  BULLETNAV_CHECK_EQ(state.size(), lanes_.size() * size);
  const auto of = [&](int lane) {
    return state.subspan(static_cast<std::size_t>(lane) * size, size);
  };
  for (const int lane : all_) {
    Start(lane, static_cast<std::uint64_t>(of(lane)[0]), static_cast<DrawMode>(of(lane)[1]));
  }
  for (std::size_t step = 0; step < most; ++step) {
    std::vector<int> moving;
    std::vector<sim::Action> actions;
    for (const int lane : all_) {
      if (step >= static_cast<std::size_t>(of(lane)[2])) continue;
      moving.push_back(lane);
      actions.push_back(
          sim::kAllActions.at(static_cast<std::size_t>(of(lane)[kStateBefore + step])));
    }
    if (moving.empty()) return;
    if (spec_.map) Look(moving);
    pool_->ForEach(static_cast<int>(moving.size()), [&](int i, int) {
      const int lane = moving[static_cast<std::size_t>(i)];
      Map(lane);
      if (spec_.teacher_stops) AskTeacher(lane);  // it remembers, too
    });
    Move(moving, actions, {});
  }
}

}  // namespace bulletnav::bench
