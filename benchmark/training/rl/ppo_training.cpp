// SPDX-License-Identifier: MIT
#include "benchmark/training/rl/ppo_training.h"

#include <array>
#include <bit>
#include <charconv>
#include <numeric>
#include <utility>

#include <fmt/core.h>

#include "agent/perception/weights.h"
#include "sim/base/error.h"
#include "sim/math/rng.h"

namespace bulletnav::bench {
namespace {

constexpr const char* kTask = "lanes.task";
constexpr const char* kActor = "lanes.actor";
constexpr const char* kHidden = "lanes.hidden";

/// The numbers that a checkpoint keeps to the bit, by their names in it.
std::array<std::pair<std::string, double*>, 7> Kept(RunningMoments* moments, PpoReport* report) {
  return {{{"return.count", &moments->count},
           {"return.mean", &moments->mean},
           {"return.squares", &moments->squares},
           {"report.entropy", &report->entropy},
           {"report.kl", &report->kl},
           {"report.clip_fraction", &report->clip_fraction},
           {"report.explained_variance", &report->explained_variance}}};
}

const agent::TensorFile::Tensor& Need(const agent::TensorFile& content, const std::string& name,
                                      const std::vector<std::int64_t>& shape,
                                      const std::filesystem::path& file) {
  const auto found = content.tensors.find(name);
  if (found == content.tensors.end() || found->second.shape != shape) {
    throw sim::FileError(file, name, "is missing: this is not a checkpoint of PPO; remove it");
  }
  return found->second;
}

std::vector<std::int64_t> Shape(const std::vector<float>& numbers) {
  return {static_cast<std::int64_t>(numbers.size())};
}

}  // namespace

PpoTraining::PpoTraining(const PpoPlan& plan, std::unique_ptr<PolicyTask> task,
                         std::unique_ptr<PolicyTask> validation)
    : plan_(plan),
      task_(std::move(task)),
      validation_(std::move(validation)),
      net_(plan.model, task_->observation_size(), task_->actions(), plan.seed),
      actor_(task_.get(), &net_, plan.seed) {}

double PpoTraining::Learn(const TrainStep& step) {
  const Rollout rollout = actor_.Play(plan_.ppo.rollout, moments_);
  const std::uint64_t seed = sim::MixSeed(plan_.seed, static_cast<std::uint64_t>(step.step));
  report_ = LearnFrom(rollout, plan_.ppo, {step.optimiser, step.rate, seed}, &net_, &moments_);
  return report_.loss;
}

Measures PpoTraining::Validate() {
  Actor actor(validation_.get(), &net_, plan_.seed + 1);
  const std::vector<double> scores = actor.Play(plan_.validation_steps, moments_).first_scores;
  const double sum = std::accumulate(scores.begin(), scores.end(), 0.0);
  const double score = sum / validation_->lanes();
  Measures measures;
  measures("loss", 1.0 - score);
  measures("score", score);
  measures("episodes", static_cast<double>(scores.size()));
  measures("entropy", report_.entropy);
  measures("kl", report_.kl);
  measures("clip_fraction", report_.clip_fraction);
  measures("explained_variance", report_.explained_variance);
  return measures;
}

std::int64_t PpoTraining::FramesAfter(int steps) const {
  return std::int64_t{steps} * plan_.ppo.lanes * plan_.ppo.rollout;
}

void PpoTraining::Save(std::map<std::string, std::string> notes,
                       const std::filesystem::path& file) const {
  agent::SaveWeights(net_, std::move(notes), agent::StoredType::kFloat32, file);
}

void PpoTraining::AppendState(agent::TensorFile* content) const {
  std::vector<float> task = task_->State();
  std::vector<float> actor = actor_.State();
  content->tensors[kTask] = {Shape(task), std::move(task)};
  content->tensors[kActor] = {Shape(actor), std::move(actor)};
  content->tensors[kHidden] = agent::ToStored(actor_.hidden());
  RunningMoments moments = moments_;
  PpoReport report = report_;
  for (const auto& [name, number] : Kept(&moments, &report)) {
    content->metadata[name] = std::to_string(std::bit_cast<std::uint64_t>(*number));
  }
}

void PpoTraining::SetState(const agent::TensorFile& content, const std::filesystem::path& file) {
  task_->SetState(Need(content, kTask, Shape(task_->State()), file).values);
  actor_.SetState(Need(content, kActor, Shape(actor_.State()), file).values,
                  agent::FromStored(Need(content, kHidden, actor_.hidden().sizes().vec(), file)));
  for (const auto& [name, number] : Kept(&moments_, &report_)) {
    const auto found = content.metadata.find(name);
    std::uint64_t bits = 0;
    if (found == content.metadata.end() ||
        std::from_chars(found->second.data(), found->second.data() + found->second.size(), bits)
                .ec != std::errc()) {
      throw sim::FileError(file, name, "is missing: this is not a checkpoint of PPO; remove it");
    }
    *number = std::bit_cast<double>(bits);
  }
}

std::string PpoTraining::Describe(const Measures& measures) const {
  return fmt::format("score {:.3f} of {:.0f} episodes, entropy {:.2f}, KL {:.4f}",
                     measures.at("score"), measures.at("episodes"), measures.at("entropy"),
                     measures.at("kl"));
}

}  // namespace bulletnav::bench
