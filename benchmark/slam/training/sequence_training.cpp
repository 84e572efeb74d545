// SPDX-License-Identifier: MIT
#include "benchmark/slam/training/sequence_training.h"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

#include <fmt/core.h>

#include "agent/perception/one_thread.h"
#include "agent/slam/descriptors/descriptor_config.h"
#include "benchmark/base/file_hash.h"
#include "benchmark/base/program_version.h"
#include "benchmark/base/ranking.h"
#include "benchmark/base/shipped_file.h"
#include "sim/base/error.h"

namespace bulletnav::bench {
namespace {

constexpr int kWindowTries = 60;         // for a window that is like another one
constexpr int kQueryTries = 200;         // for one that has any
constexpr double kSameWindow = 0.5;      // of the frames are covisible
constexpr int kValidationWindows = 120;  // a walk
constexpr std::uint64_t kValidationSeed = 1'000'003;

PlaceDataConfig ValidationOf(const SequencePlan& plan) {
  PlaceTrainConfig named;
  named.data = plan.data;
  named.validation = plan.validation;
  return ValidationData(named);
}

std::vector<SequenceWalk> WalksThrough(const PlaceDataConfig& data, int scenes, int walks,
                                       const SequencePlan& plan, const TrainContext& context) {
  MakeHousesOf(data, CommittedVersion(), 0, context.start);
  const auto all = static_cast<int>(ScenesOf(data).size());
  const int count = scenes == 0 ? all : std::min(scenes, all);
  const auto weights = ShippedOr(plan.descriptor);
  return MakeSequenceWalks(data, count, walks, plan.frames, weights,
                           context.start("walking through scenes", count));
}

bool Overlap(const Window& a, const Window& b) {
  return a.first < b.first + b.count && b.first < a.first + a.count;
}

/// Within a sequence of the walk, or as far as the walk goes where that is shorter.
Window WindowOf(const SequenceWalk& walk, int length, sim::Rng* rng) {
  const agent::Sequence& sequence = rng->Pick(walk.sequences);
  const int room = std::max(0, sequence.size() - length);
  const int first = sequence.first + rng->Below(room + 1);
  return {std::min(first, walk.frames - length), length};
}

}  // namespace

void SequencePlan::Validate() const {
  TrainPlan::Validate();
  internal::RequireAtLeast(0, walk_scenes, "walk_scenes");
  internal::RequireAtLeast(1, walks, "walks");
  internal::RequireAtLeast(50, frames, "frames");
  internal::RequireAtLeast(1, queries, "queries");
  internal::RequireAtLeast(1, negatives, "negatives");
  if (!(margin > 0.0)) throw sim::KeyError("margin", "margin must be positive");
}

SequenceWalks SequenceTraining::MakeWalks(const SequencePlan& plan, const TrainContext& context) {
  if (!plan.data) {
    throw sim::KeyError("data", "there is no block 'data'; see configs/train/seqvlad.yaml");
  }
  return {WalksThrough(*plan.data, plan.walk_scenes, plan.walks, plan, context),
          WalksThrough(ValidationOf(plan), 0, 1, plan, context),
          FileHash(ShippedOr(plan.descriptor))};
}

SequenceTraining::SequenceTraining(const SequencePlan& plan, const SequenceLengths& lengths,
                                   std::string name, SequenceWalks walks)
    : plan_(plan), lengths_(lengths), name_(std::move(name)), walks_(std::move(walks)) {
  for (const auto* some : {&walks_.train, &walks_.validation}) {
    if (some->empty()) throw sim::Error("there is no walk to learn from");
    for (const SequenceWalk& walk : *some) {
      if (walk.frames <= 2 * lengths_.longest) throw sim::Error("walks are too short");
    }
  }
}

void SequenceTraining::Save(std::map<std::string, std::string> notes,
                            const std::filesystem::path& file) const {
  const torch::NoGradGuard no_grad;
  agent::StayInThisThread();
  if (!walks_.descriptor_hash.empty()) notes[agent::kDescriptorHashKey] = walks_.descriptor_hash;
  SaveNet(std::move(notes), file);
}

Window SequenceTraining::DrawWindow(const SequenceWalk& walk, sim::Rng* rng) const {
  return WindowOf(walk, rng->Between(lengths_.shortest, lengths_.longest), rng);
}

/// A query with one window like it and some that share nothing with it.
struct SequenceTraining::Triplet {
  const SequenceWalk* walk = nullptr;
  std::vector<Window> windows;
};

/// All windows of a step have two lengths: that of queries and that of the others.
SequenceTraining::Triplet SequenceTraining::DrawTriplet(int query_length, int length,
                                                        sim::Rng* rng) const {
  for (int i = 0; i < kQueryTries; ++i) {
    Triplet triplet;
    triplet.walk = &rng->Pick(walks_.train);
    const Window query = WindowOf(*triplet.walk, query_length, rng);
    std::vector<Window> unlike;
    std::optional<Window> like;
    for (int k = 0; k < kWindowTries; ++k) {
      const Window other = WindowOf(*triplet.walk, length, rng);
      if (Overlap(query, other)) continue;
      const double share = ShareCovisible(*triplet.walk, query, other);
      if (share >= kSameWindow && !like) like = other;
      if (share == 0.0 && static_cast<int>(unlike.size()) < plan_.negatives) {
        unlike.push_back(other);
      }
    }
    if (!like || static_cast<int>(unlike.size()) < plan_.negatives) continue;
    triplet.windows = {query, *like};
    triplet.windows.insert(triplet.windows.end(), unlike.begin(), unlike.end());
    return triplet;
  }
  throw sim::Error("no two stretches of the walks see the same; walk farther");
}

torch::Tensor SequenceTraining::LossOf(int step) {
  sim::Rng rng =
      sim::Rng(plan_.seed, name_ + " step").Fork("number", static_cast<std::uint64_t>(step));
  const int query_length = rng.Between(lengths_.shortest, lengths_.longest);
  const int length = rng.Between(lengths_.shortest, lengths_.longest);
  torch::Tensor sum = torch::zeros({});
  for (int i = 0; i < plan_.queries; ++i) {
    const Triplet triplet = DrawTriplet(query_length, length, &rng);
    const std::span<const Window> windows = triplet.windows;
    const torch::Tensor query = DescribeWindows(*triplet.walk, windows.first(1));
    const torch::Tensor others = DescribeWindows(*triplet.walk, windows.subspan(1));
    const torch::Tensor cosines = at::matmul(others, query.t()).squeeze(1);
    const torch::Tensor distances = (2.0 - 2.0 * cosines).clamp_min(1e-8).sqrt();
    const torch::Tensor off = distances.narrow(0, 0, 1) - distances.narrow(0, 1, plan_.negatives);
    sum = sum + (off + plan_.margin).relu().mean();
  }
  return sum / plan_.queries;
}

/// Ranks windows of all lengths that are learned. `describe(walk, window)` gives something that
/// `cosine` compares.
template <class Describer, class Cosine>
Measures SequenceTraining::Rank(const Describer& describe, const Cosine& cosine) const {
  double ap = 0.0;
  double guessing = 0.0;
  for (std::size_t w = 0; w < walks_.validation.size(); ++w) {
    const SequenceWalk& walk = walks_.validation[w];
    sim::Rng rng = sim::Rng(plan_.seed + kValidationSeed, name_ + " windows").Fork("walk", w);
    std::vector<Window> windows;
    for (int i = 0; i < kValidationWindows; ++i) windows.push_back(DrawWindow(walk, &rng));
    std::vector<std::invoke_result_t<Describer, const SequenceWalk&, const Window&>> described;
    for (const Window& window : windows) described.push_back(describe(walk, window));
    std::vector<Answer> answers;
    int same = 0;
    for (std::size_t a = 0; a < windows.size(); ++a) {
      for (std::size_t b = 0; b < a; ++b) {
        if (Overlap(windows[a], windows[b])) continue;
        const bool is_same = ShareCovisible(walk, windows[a], windows[b]) >= kSameWindow;
        same += is_same ? 1 : 0;
        answers.push_back({static_cast<float>(cosine(described[a], described[b])), is_same});
      }
    }
    guessing +=
        static_cast<double>(same) / std::max<double>(1.0, static_cast<double>(answers.size()));
    ap += AveragePrecision(PrecisionRecallCurve(std::move(answers)));
  }
  const auto count = static_cast<double>(walks_.validation.size());
  Measures measures;
  measures("loss", 1.0 - ap / count);
  measures("ap", ap / count);
  measures("guessing", guessing / count);
  return measures;
}

Measures SequenceTraining::MeasuresOf(const InIntegers& describe) const {
  return Rank(describe, [](const agent::PictureDescriptor& a, const agent::PictureDescriptor& b) {
    return agent::Cosine(a, b);
  });
}

double SequenceTraining::Learn(const TrainStep& step) {
  agent::StayInThisThread();
  const torch::Tensor loss = LossOf(step.step);
  loss.backward();
  const auto value = loss.item<double>();
  if (std::isfinite(value)) step.optimiser->Step(step.rate);
  return value;
}

Measures SequenceTraining::Validate() {
  const torch::NoGradGuard no_grad;
  agent::StayInThisThread();
  return Rank(
      [this](const SequenceWalk& walk, const Window& window) {
        return DescribeWindows(walk, {&window, 1});
      },
      [](const torch::Tensor& a, const torch::Tensor& b) {
        return (a * b).sum().item<double>();
      });
}

std::int64_t SequenceTraining::FramesAfter(int steps) const {
  return std::int64_t{steps} * plan_.queries * (2 + plan_.negatives);
}

std::string SequenceTraining::Describe(const Measures& m) const {
  return fmt::format("AP of sequences {:.3f} (guessing {:.3f})", m.at("ap"), m.at("guessing"));
}

}  // namespace bulletnav::bench
