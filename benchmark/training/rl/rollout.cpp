// SPDX-License-Identifier: MIT
#include "benchmark/training/rl/rollout.h"

#include <algorithm>
#include <numeric>

#include <fmt/core.h>

#include "agent/perception/one_thread.h"
#include "benchmark/base/memory.h"
#include "sim/base/check.h"
#include "sim/math/rng.h"

namespace bulletnav::bench {
namespace {

constexpr std::size_t kStateNumbers = 6;  // of a lane's state

std::int64_t Wide(std::size_t size) {
  return static_cast<std::int64_t>(size);
}

torch::Tensor Indices(const std::vector<std::int64_t>& indices) {
  return at::tensor(indices, torch::kInt64);
}

}  // namespace

ActorCritic::Seen Rollout::SeenBy(ActorCritic* net, const torch::Tensor& lanes) const {
  ActorCritic::Seen seen;
  seen.numbers = numbers.index_select(1, lanes);
  if (goals.defined()) SeeGoals(net, lanes, &seen);
  if (codes.defined()) seen.codes = codes.index_select(1, lanes);
  if (codes.defined() || !pictures.defined()) return seen;
  const torch::Tensor shown = pictures.index_select(1, lanes);
  const std::int64_t rows = shown.size(0);
  const std::int64_t columns = shown.size(1);
  seen.codes = net->Encode(shown.view({rows * columns, -1})).view({rows, columns, -1});
  return seen;
}

void Rollout::SeeGoals(ActorCritic* net, const torch::Tensor& lanes,
                       ActorCritic::Seen* seen) const {
  const torch::Tensor index = goal_index.index_select(1, lanes);
  const std::int64_t rows = index.size(0);
  const std::int64_t columns = index.size(1);
  const auto in_order = at::_unique(index.reshape({-1}), true, true);
  const torch::Tensor used = goals.index_select(0, std::get<0>(in_order));
  const bool learns = !codes.defined();
  const torch::Tensor coded = learns ? net->Encode(used) : used;
  seen->goal_codes = coded.index_select(0, std::get<1>(in_order)).view({rows, columns, -1});
}

int SampleAction(const ActionKey& key, const ActorCritic& policy, std::span<const float> said) {
  sim::Rng rng = sim::Rng(key.seed, "action")
                     .Fork("lane", static_cast<std::uint64_t>(key.lane))
                     .Fork("episode", key.episode)
                     .Fork("step", key.step);
  return policy.Draw(said, &rng);
}

struct Actor::Now {
  torch::Tensor numbers;   // [lanes, size]
  torch::Tensor pictures;  // u8 [lanes, bytes]
  torch::Tensor codes;     // what was made of them, once asked
};

Actor::Actor(PolicyTask* task, ActorCritic* net, sim::WorkerPool* pool, int group,
             std::uint64_t seed)
    : task_(task),
      net_(net),
      pool_(pool),
      group_(group),
      seed_(seed),
      hidden_(net->NoMemory(task->lanes())),
      starts_(torch::ones({task->lanes()})),
      episodes_(static_cast<std::size_t>(task->lanes())),
      steps_(episodes_.size()),
      returns_(episodes_.size()) {
  BULLETNAV_CHECK(group >= 1);
  const std::size_t bytes = task->picture_bytes();
  if (bytes > 0 && task->shows_goals())
    goals_ = torch::zeros({Wide(lanes()), Wide(bytes)}, torch::kUInt8);
  for (std::size_t i = 0; i < lanes(); ++i) Begin(i, 0);
}

Actor::Now Actor::Observe() {
  Now now;
  now.numbers = torch::empty({Wide(lanes()), task_->observation_size()});
  const std::size_t bytes = task_->picture_bytes() * lanes();
  std::span<std::uint8_t> pictures;
  if (bytes > 0) {
    now.pictures = torch::empty({Wide(lanes()), Wide(task_->picture_bytes())}, torch::kUInt8);
    pictures = {now.pictures.data_ptr<std::uint8_t>(), bytes};
  }
  task_->Observe({now.numbers.data_ptr<float>(), static_cast<std::size_t>(now.numbers.numel())},
                 pictures);
  return now;
}

/// Each by itself: an episode's goal is coded alike whenever that is.
void Actor::EncodeGoals(const std::vector<std::int64_t>& lanes) {
  if (!goals_.defined() || lanes.empty()) return;
  std::vector<torch::Tensor> coded(lanes.size());
  pool_->ForEach(static_cast<int>(lanes.size()), [&](int i, int) {
    const torch::NoGradGuard no_grad;
    agent::StayInThisThread();
    const auto at = static_cast<std::size_t>(i);
    coded[at] = net_->Encode(goals_.narrow(0, lanes[at], 1));
  });
  if (!goal_codes_.defined()) {
    goal_codes_ = torch::zeros({Wide(this->lanes()), coded.front().size(1)});
  }
  for (std::size_t i = 0; i < lanes.size(); ++i) {
    goal_codes_.narrow(0, lanes[i], 1).copy_(coded[i]);
  }
}

ActorCritic::Output Actor::Ask(Now* now) {
  const std::int64_t count = Wide(lanes());
  const std::int64_t groups = (count + group_ - 1) / group_;
  std::vector<ActorCritic::Output> parts(static_cast<std::size_t>(groups));
  std::vector<torch::Tensor> codes(parts.size());
  pool_->ForEach(static_cast<int>(groups), [&](int i, int) {
    const torch::NoGradGuard no_grad;
    agent::StayInThisThread();
    const std::int64_t first = i * group_;
    const std::int64_t size = std::min(group_, count - first);
    const auto of = [&](const torch::Tensor& all) {
      return all.narrow(0, first, size);
    };
    ActorCritic::Seen seen;
    seen.numbers = of(now->numbers).unsqueeze(0);
    torch::Tensor& code = codes[static_cast<std::size_t>(i)];
    if (now->pictures.defined()) {
      code = net_->Encode(of(now->pictures));
      seen.codes = code.unsqueeze(0);
      if (goal_codes_.defined()) seen.goal_codes = of(goal_codes_).unsqueeze(0);
    }
    parts[static_cast<std::size_t>(i)] = net_->Run(seen, of(starts_).unsqueeze(0), of(hidden_));
  });
  std::vector<torch::Tensor> probabilities, values, hidden;
  for (const ActorCritic::Output& part : parts) {
    probabilities.push_back(part.log_probabilities);
    values.push_back(part.values);
    hidden.push_back(part.hidden);
  }
  if (now->pictures.defined()) now->codes = at::cat(codes);
  return {at::cat(probabilities, 1), at::cat(values, 1), at::cat(hidden)};
}

/// What is kept of each step while it is played.
struct Actor::Record {
  std::vector<torch::Tensor> numbers, pictures, codes, goals, goal_index, starts, actions, lessons;
  std::vector<torch::Tensor> log_probabilities;
  std::vector<std::int64_t> goal_of_lane;
  std::int64_t goal_count = 0;
  bool keeps_pictures = false;  // of goals, too
  bool asks = false;
};

/// Of what it keeps, which is there twice when the steps are put together.
void Actor::CheckMemory(const PlaySpec& spec, const Record& record) const {
  const bool keeps_pictures = record.keeps_pictures || spec.pictures;
  const bool keeps_codes = goal_codes_.defined() && !record.keeps_pictures;
  const double codes = keeps_codes ? static_cast<double>(goal_codes_.size(1)) : 0.0;
  const double numbers = task_->observation_size() + codes;
  const double step = sizeof(LaneStep) + numbers * sizeof(float) +
                      (keeps_pictures ? static_cast<double>(task_->picture_bytes()) : 0.0);
  const double all = 2.0 * step * spec.steps * static_cast<double>(lanes());
  RequireMemory(all, fmt::format("a rollout of {} steps in {} lanes", spec.steps, lanes()),
                "take a shorter rollout or fewer lanes");
}

Actor::Record Actor::BeginRecord(const PlaySpec& spec) {
  Record record;
  const bool has_pictures = task_->picture_bytes() > 0;
  record.keeps_pictures = has_pictures && net_->learns_to_see();
  const bool keeps_codes = has_pictures && !record.keeps_pictures;
  record.asks = keeps_codes || !(spec.lessons && spec.taught_episodes >= 1.0);
  record.goal_of_lane.resize(lanes());
  std::iota(record.goal_of_lane.begin(), record.goal_of_lane.end(), 0);
  AddGoals(record.goal_of_lane, &record);
  if (!has_checked_memory_) CheckMemory(spec, record);
  has_checked_memory_ = true;
  return record;
}

void Actor::AddGoals(const std::vector<std::int64_t>& lanes, Record* record) {
  if (!goals_.defined() || lanes.empty()) return;
  if (record->asks) EncodeGoals(lanes);
  const torch::Tensor& rows = record->keeps_pictures ? goals_ : goal_codes_;
  record->goals.push_back(rows.index_select(0, Indices(lanes)));
  for (const std::int64_t lane : lanes) {
    record->goal_of_lane[static_cast<std::size_t>(lane)] = record->goal_count++;
  }
}

/// The actions of a step. `output`: what the net says, if it is asked.
std::vector<int> Actor::Choose(const PlaySpec& spec, Record* record, ActorCritic::Output* output) {
  Now now = Observe();
  record->numbers.push_back(now.numbers);
  record->starts.push_back(starts_.clone());
  record->goal_index.push_back(Indices(record->goal_of_lane));
  std::vector<int> actions(lanes());
  if (record->asks) {
    *output = Ask(&now);
    hidden_ = output->hidden;
    Act(*output, &actions);
  }
  if (now.pictures.defined()) {
    if (record->keeps_pictures || spec.pictures) record->pictures.push_back(now.pictures);
    if (!record->keeps_pictures) record->codes.push_back(now.codes);
  }
  starts_ = torch::zeros_like(starts_);
  if (spec.lessons) {
    std::vector<Lesson> taught(lanes());
    BULLETNAV_CHECK(task_->Teach(taught));
    std::vector<std::int64_t> lessons;
    for (std::size_t i = 0; i < lanes(); ++i) {
      lessons.push_back(taught[i].counts ? taught[i].action : kNoLesson);
      if (IsTaught(i, spec.taught_episodes)) actions[i] = taught[i].action;
    }
    record->lessons.push_back(Indices(lessons));
  }
  const torch::Tensor chosen = Indices({actions.begin(), actions.end()});
  record->actions.push_back(chosen);
  if (record->asks) {
    record->log_probabilities.push_back(
        net_->LogProbabilitiesOf(*output, chosen.unsqueeze(0)).squeeze(0));
  }
  return actions;
}

Rollout Actor::Play(const PlaySpec& spec, const RunningMoments& moments) {
  const torch::NoGradGuard no_grad;
  Rollout rollout;
  rollout.hidden = hidden_.clone();
  rollout.steps.resize(lanes());
  Record record = BeginRecord(spec);
  std::vector<LaneOutcome> outcomes(lanes());
  for (int t = 0; t < spec.steps; ++t) {
    ActorCritic::Output output;
    task_->Step(Choose(spec, &record, &output), outcomes);
    const bool has_cut =
        std::any_of(outcomes.begin(), outcomes.end(), [](const LaneOutcome& outcome) {
          return outcome.truncated;
        });
    std::vector<double> values(lanes());
    std::vector<double> cut_values(lanes());
    if (spec.values) values = ValuesOf(output.values[0], moments);
    if (spec.values && has_cut) cut_values = ValuesHere(moments);
    for (std::size_t i = 0; i < lanes(); ++i) {
      const LaneOutcome& outcome = outcomes[i];
      rollout.steps[i].push_back(
          {outcome.reward, values[i], outcome.terminated, outcome.truncated, cut_values[i]});
      returns_[i].now += static_cast<float>(outcome.reward);
      if (!outcome.is_over()) continue;
      EndReturn(&returns_[i]);
      rollout.ended.push_back({task_->first_lane() + static_cast<int>(i), episodes_[i],
                               outcome.score, outcome.success, steps_[i] + 1});
    }
    AddGoals(BeginOver(outcomes), &record);
  }
  if (spec.values) rollout.last_values = ValuesHere(moments);
  Stack(record, &rollout);
  return rollout;
}

void Actor::Stack(const Record& record, Rollout* rollout) const {
  rollout->numbers = at::stack(record.numbers);
  rollout->starts = at::stack(record.starts);
  rollout->actions = at::stack(record.actions);
  rollout->goal_index = at::stack(record.goal_index);
  if (!record.lessons.empty()) rollout->lessons = at::stack(record.lessons);
  if (record.asks) rollout->log_probabilities = at::stack(record.log_probabilities);
  if (!record.pictures.empty()) rollout->pictures = at::stack(record.pictures);
  if (!record.codes.empty()) rollout->codes = at::stack(record.codes);
  if (goals_.defined()) rollout->goals = at::cat(record.goals);
}

void Actor::Act(const ActorCritic::Output& output, std::vector<int>* actions) const {
  const torch::Tensor flat = output.log_probabilities.contiguous();
  const auto count = static_cast<std::size_t>(flat.size(-1));
  for (std::size_t i = 0; i < actions->size(); ++i) {
    (*actions)[i] =
        SampleAction({seed_, task_->first_lane() + static_cast<int>(i), episodes_[i], steps_[i]},
                     *net_, {flat.data_ptr<float>() + i * count, count});
  }
}

/// Drawn once an episode; if the share falls meanwhile, the teacher may stop acting within it.
bool Actor::IsTaught(std::size_t lane, double share) const {
  sim::Rng rng = sim::Rng(seed_, "taught")
                     .Fork("lane", static_cast<std::uint64_t>(task_->first_lane()) + lane)
                     .Fork("episode", episodes_[lane]);
  return rng.Uniform() < share;
}

std::vector<double> Actor::ValuesOf(const torch::Tensor& values,
                                    const RunningMoments& moments) const {
  std::vector<double> all(lanes());
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i] = values[Wide(i)].item<double>() * moments.deviation() + moments.mean;
  }
  return all;
}

std::vector<double> Actor::ValuesHere(const RunningMoments& moments) {
  Now now = Observe();
  return ValuesOf(Ask(&now).values[0], moments);
}

/// The lanes whose next episode began.
std::vector<std::int64_t> Actor::BeginOver(const std::vector<LaneOutcome>& outcomes) {
  std::vector<std::int64_t> begun;
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    ++steps_[i];
    if (!outcomes[i].is_over()) continue;
    begun.push_back(Wide(i));
    Begin(i, episodes_[i] + 1);
  }
  return begun;
}

void Actor::Begin(std::size_t lane, std::uint64_t episode) {
  task_->Begin(static_cast<int>(lane), episode);
  episodes_[lane] = episode;
  steps_[lane] = 0;
  starts_[Wide(lane)] = 1.0;
  LookAtGoal(lane);
}

void Actor::LookAtGoal(std::size_t lane) {
  if (!goals_.defined()) return;
  torch::Tensor goal = goals_[Wide(lane)];
  task_->ShowGoal(static_cast<int>(lane),
                  {goal.data_ptr<std::uint8_t>(), static_cast<std::size_t>(goal.numel())});
}

void Actor::EndReturn(Return* of_lane) {
  of_lane->ended += of_lane->now;
  of_lane->count += 1.0f;
  of_lane->now = 0.0f;
}

std::vector<double> Actor::TakeReturns() {
  std::vector<double> taken;
  taken.reserve(2 * lanes());
  for (Return& of_lane : returns_) {
    taken.push_back(of_lane.ended);
    taken.push_back(of_lane.count);
    of_lane.ended = 0.0f;
    of_lane.count = 0.0f;
  }
  return taken;
}

std::vector<float> Actor::State() const {
  std::vector<float> state;
  state.reserve(kStateNumbers * lanes());
  for (std::size_t i = 0; i < lanes(); ++i) {
    state.push_back(static_cast<float>(episodes_[i]));
    state.push_back(static_cast<float>(steps_[i]));
    state.push_back(starts_[Wide(i)].item<float>());
    state.push_back(returns_[i].now);
    state.push_back(returns_[i].ended);
    state.push_back(returns_[i].count);
  }
  return state;
}

void Actor::SetState(const std::vector<float>& state, const torch::Tensor& hidden) {
  BULLETNAV_CHECK(state.size() == kStateNumbers * lanes());
  for (std::size_t i = 0; i < lanes(); ++i) {
    const float* of_lane = &state[kStateNumbers * i];
    episodes_[i] = static_cast<std::uint64_t>(of_lane[0]);
    steps_[i] = static_cast<std::uint64_t>(of_lane[1]);
    starts_[Wide(i)] = of_lane[2];
    returns_[i] = {of_lane[3], of_lane[4], of_lane[5]};
    LookAtGoal(i);
  }
  hidden_ = hidden.clone();
}

}  // namespace bulletnav::bench
