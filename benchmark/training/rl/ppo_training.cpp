// SPDX-License-Identifier: MIT
#include "benchmark/training/rl/ppo_training.h"

#include <array>
#include <bit>
#include <charconv>
#include <utility>
#include <vector>

#include "agent/perception/weights.h"
#include "benchmark/training/rl/lanes_state.h"
#include "sim/base/error.h"
#include "sim/math/rng.h"

namespace bulletnav::bench {
namespace {

using Numbers = std::vector<std::pair<std::string, double*>>;

/// The numbers that weights keep to the bit, by their names in the metadata.
Numbers Kept(RunningMoments* moments) {
  return {{"return.count", &moments->count},
          {"return.mean", &moments->mean},
          {"return.squares", &moments->squares}};
}

/// And those of a checkpoint.
Numbers Kept(RunningMoments* moments, PpoReport* report, double* episode_return) {
  Numbers all = Kept(moments);
  all.insert(all.end(), {{"report.entropy", &report->entropy},
                         {"report.kl", &report->kl},
                         {"report.clip_fraction", &report->clip_fraction},
                         {"report.explained_variance", &report->explained_variance},
                         {"report.return", episode_return}});
  return all;
}

using Metadata = std::map<std::string, std::string>;

void Write(const Numbers& numbers, Metadata* metadata) {
  for (const auto& [name, number] : numbers) {
    (*metadata)[name] = std::to_string(std::bit_cast<std::uint64_t>(*number));
  }
}

/// Throws FileError if one is missing; `remedy` ends its message.
void Read(const Metadata& metadata, const std::filesystem::path& file, const std::string& remedy,
          const Numbers& numbers) {
  for (const auto& [name, number] : numbers) {
    const auto found = metadata.find(name);
    std::uint64_t bits = 0;
    if (found == metadata.end() ||
        std::from_chars(found->second.data(), found->second.data() + found->second.size(), bits)
                .ec != std::errc()) {
      throw sim::FileError(file, name, "is missing: " + remedy);
    }
    *number = std::bit_cast<double>(bits);
  }
}

}  // namespace

PpoTraining::PpoTraining(const PpoPlan& plan, const ActorCriticMaker& make,
                         const std::function<std::unique_ptr<PolicyTask>(sim::WorkerPool*)>& task,
                         std::shared_ptr<Peers> peers)
    : plan_(plan),
      peers_(std::move(peers)),
      pool_(peers_ ? peers_->threads() : 0),
      net_(make()),
      task_(task(&pool_)),
      groups_(plan.ppo.lanes, plan.ppo.group, make, net_.get(), &pool_, peers_.get()),
      actor_(std::make_unique<Actor>(task_.get(), net_.get(), &pool_, plan.ppo.group, plan.seed)) {}

LaneShare PpoTraining::Share(const PpoSpec& spec, const Peers* peers) {
  return ShareOf(spec.lanes, spec.group, spec.minibatches, peers);
}

double PpoPlan::RateAt(int step) const {
  return optimiser.RateAt(step, steps, step < ppo.value_first ? 0 : ppo.value_first);
}

double PpoTraining::Learn(const TrainStep& step) {
  PlaySpec play;
  play.steps = plan_.ppo.rollout;
  task_->StartRollout(1.0 * step.step / plan_.steps);
  const Rollout rollout = actor_->Play(play, moments_);
  const std::uint64_t seed = sim::MixSeed(plan_.seed, static_cast<std::uint64_t>(step.step));
  const PpoStep update = {step.optimiser, step.rate, seed, step.step < plan_.ppo.value_first};
  report_ = LearnFrom(rollout, plan_.ppo, update, &groups_, net_.get(), &moments_);
  return report_.loss;
}

/// Lane by lane, so that it is the same for any number of processes.
void PpoTraining::TakeEpisodeReturn() {
  const std::vector<double> returns = groups_.Gather(actor_->TakeReturns());
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i + 1 < returns.size(); i += 2) {
    sum += returns[i];
    count += returns[i + 1];
  }
  if (count > 0.0) episode_return_ = sum / count;
}

void PpoTraining::AppendReport(Measures* measures) {
  TakeEpisodeReturn();
  (*measures)("return", episode_return_);
  (*measures)("entropy", report_.entropy);
  (*measures)("kl", report_.kl);
  (*measures)("clip_fraction", report_.clip_fraction);
  (*measures)("explained_variance", report_.explained_variance);
}

std::int64_t PpoTraining::FramesAfter(int steps) const {
  return std::int64_t{steps} * plan_.ppo.lanes * plan_.ppo.rollout;
}

void PpoTraining::Save(std::map<std::string, std::string> notes,
                       const std::filesystem::path& file) const {
  agent::SaveWeights(*net_, std::move(notes), agent::StoredType::kFloat32, file);
}

void PpoTraining::AppendState(agent::TensorFile* content) const {
  AppendLanes({task_.get(), actor_.get(), peers_.get()}, content);
  RunningMoments moments = moments_;
  PpoReport report = report_;
  double episode_return = episode_return_;
  Write(Kept(&moments, &report, &episode_return), &content->metadata);
}

void PpoTraining::SetState(const agent::TensorFile& content, const std::filesystem::path& file) {
  SetLanes(content, file, {task_.get(), actor_.get(), peers_.get()});
  Read(content.metadata, file, "this is not a checkpoint of PPO; remove it",
       Kept(&moments_, &report_, &episode_return_));
}

std::map<std::string, std::string> PpoTraining::WithReturns(
    std::map<std::string, std::string> notes) const {
  RunningMoments moments = moments_;
  Write(Kept(&moments), &notes);
  return notes;
}

void PpoTraining::TakeReturns(const std::filesystem::path& weights) {
  const agent::TensorFile content = agent::ReadTensorFile(weights);
  const Numbers numbers = Kept(&moments_);
  if (!content.metadata.contains(numbers.front().first)) return;
  Read(content.metadata, weights, "train the policy again", numbers);
}

}  // namespace bulletnav::bench
