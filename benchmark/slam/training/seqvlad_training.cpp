// SPDX-License-Identifier: MIT
#include "benchmark/slam/training/seqvlad_training.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>

#include <fmt/core.h>

#include "agent/perception/one_thread.h"
#include "agent/slam/descriptors/seqvlad.h"
#include "benchmark/base/ranking.h"
#include "benchmark/base/shipped_file.h"
#include "benchmark/slam/training/seqvlad_net.h"
#include "sim/base/error.h"
#include "sim/math/rng.h"

namespace bulletnav::bench {
namespace {

constexpr int kWindowTries = 60;         // for a window that is like another one
constexpr int kQueryTries = 200;         // for one that has any
constexpr double kSameWindow = 0.5;      // of the frames are covisible
constexpr int kStartCells = 20'000;      // that clusters are begun from
constexpr int kDirectionWindows = 1200;  // that principal components are of
constexpr int kValidationWindows = 120;  // a walk
constexpr std::uint64_t kValidationSeed = 1'000'003;

/// A query with one window like it and some that share nothing with it.
struct Triplet {
  const SequenceWalk* walk = nullptr;
  std::vector<Window> windows;
};

PlaceDataConfig ValidationOf(const SeqVladTrainConfig& config) {
  PlaceTrainConfig named;
  named.data = config.data;
  named.validation = config.validation;
  return ValidationData(named);
}

const PlaceDataConfig& DataOf(const SeqVladTrainConfig& config) {
  if (config.data) return *config.data;
  throw sim::KeyError("data", "there is no block 'data'; see configs/train/seqvlad.yaml");
}

std::vector<SequenceWalk> Walks(const PlaceDataConfig& data, int scenes, int walks,
                                const SeqVladTrainConfig& config, const TrainContext& context) {
  MakeHousesOf(data, context.start);
  const auto all = static_cast<int>(ScenesOf(data).size());
  const int count = scenes == 0 ? all : std::min(scenes, all);
  const auto weights = FindShipped(config.descriptor).value_or(config.descriptor);
  return MakeSequenceWalks(data, count, walks, config.frames, weights,
                           context.start("walking through scenes", count));
}

bool Overlap(const Window& a, const Window& b) {
  return a.first < b.first + b.count && b.first < a.first + a.count;
}

}  // namespace

struct SeqVladTraining::Work {
  Work(const SeqVladTrainConfig& config_in, std::vector<SequenceWalk> train_in,
       std::vector<SequenceWalk> validation_in)
      : config(config_in),
        train(std::move(train_in)),
        validation(std::move(validation_in)),
        net(config_in.model, config_in.seed) {
    for (const auto* walks : {&train, &validation}) {
      if (walks->empty()) throw sim::Error("there is no walk to learn from");
      for (const SequenceWalk& walk : *walks) {
        const bool fits = walk.frame_bytes % static_cast<std::size_t>(config.model.channels) == 0;
        if (fits && walk.frames > 2 * config.longest) continue;
        throw sim::Error("walks are too short, or the model's channels are not those of the cells");
      }
    }
    sim::Rng rng(config.seed, "seqvlad start");
    net.StartFrom(SomeCells(&rng), &rng);
  }

  /// Cells of frames at random, rows of length 1.
  Eigen::MatrixXf SomeCells(sim::Rng* rng) const {
    Eigen::MatrixXf cells(kStartCells, config.model.channels);
    const auto channels = static_cast<std::size_t>(config.model.channels);
    for (int row = 0; row < kStartCells; ++row) {
      const SequenceWalk& walk = rng->Pick(train);
      const auto count = static_cast<int>(walk.cells.size() / channels);
      const auto at = static_cast<std::size_t>(rng->Below(count)) * channels;
      for (std::size_t i = 0; i < channels; ++i) {
        cells(row, static_cast<Eigen::Index>(i)) = static_cast<float>(walk.cells[at + i]);
      }
      cells.row(row) /= std::max(1.0f, cells.row(row).norm());
    }
    return cells;
  }

  /// Within a sequence of the walk, or as far as the walk goes where that is shorter.
  static Window WindowOf(const SequenceWalk& walk, int length, sim::Rng* rng) {
    const agent::Sequence& sequence = rng->Pick(walk.sequences);
    const int room = std::max(0, sequence.size() - length);
    const int first = sequence.first + rng->Below(room + 1);
    return {std::min(first, walk.frames - length), length};
  }

  /// All windows of a step have two lengths: that of queries and that of the others.
  Triplet TripletOf(int query_length, int length, sim::Rng* rng) const {
    for (int i = 0; i < kQueryTries; ++i) {
      Triplet triplet;
      triplet.walk = &rng->Pick(train);
      const Window query = WindowOf(*triplet.walk, query_length, rng);
      std::vector<Window> unlike;
      std::optional<Window> like;
      for (int k = 0; k < kWindowTries; ++k) {
        const Window other = WindowOf(*triplet.walk, length, rng);
        if (Overlap(query, other)) continue;
        const double share = ShareCovisible(*triplet.walk, query, other);
        if (share >= kSameWindow && !like) like = other;
        if (share == 0.0 && static_cast<int>(unlike.size()) < config.negatives) {
          unlike.push_back(other);
        }
      }
      if (!like || static_cast<int>(unlike.size()) < config.negatives) continue;
      triplet.windows = {query, *like};
      triplet.windows.insert(triplet.windows.end(), unlike.begin(), unlike.end());
      return triplet;
    }
    throw sim::Error("no two stretches of the walks see the same; walk farther");
  }

  torch::Tensor CellsOf(const SequenceWalk& walk, std::span<const Window> windows) const {
    std::vector<std::uint8_t> bytes;
    for (const Window& window : windows) {
      const auto some = walk.Frames(window.first, window.count);
      bytes.insert(bytes.end(), some.begin(), some.end());
    }
    return CellDirections(bytes, static_cast<int>(windows.size()), config.model.channels);
  }

  torch::Tensor LossOf(int step) {
    sim::Rng rng =
        sim::Rng(config.seed, "seqvlad step").Fork("number", static_cast<std::uint64_t>(step));
    const int query_length = rng.Between(config.shortest, config.longest);
    const int length = rng.Between(config.shortest, config.longest);
    torch::Tensor sum = torch::zeros({});
    for (int i = 0; i < config.queries; ++i) {
      const Triplet triplet = TripletOf(query_length, length, &rng);
      const std::span<const Window> windows = triplet.windows;
      const torch::Tensor query = net.forward(CellsOf(*triplet.walk, windows.first(1)));
      const torch::Tensor others = net.forward(CellsOf(*triplet.walk, windows.subspan(1)));
      const torch::Tensor cosines = at::matmul(others, query.t()).squeeze(1);
      const torch::Tensor distances = (2.0 - 2.0 * cosines).clamp_min(1e-8).sqrt();
      const torch::Tensor off =
          distances.narrow(0, 0, 1) - distances.narrow(0, 1, config.negatives);
      sum = sum + (off + config.margin).relu().mean();
    }
    return sum / config.queries;
  }

  /// Windows that are ranked: of all lengths that are learned.
  std::vector<Window> ValidationWindows(const SequenceWalk& walk, std::uint64_t number) const {
    sim::Rng rng = sim::Rng(config.seed + kValidationSeed, "seqvlad windows").Fork("walk", number);
    std::vector<Window> windows;
    for (int i = 0; i < kValidationWindows; ++i) {
      windows.push_back(WindowOf(walk, rng.Between(config.shortest, config.longest), &rng));
    }
    return windows;
  }

  /// `describe(walk, window)` gives something that `cosine` compares.
  template <class Describe, class Cosine>
  Measures MeasuresOf(const Describe& describe, const Cosine& cosine) const {
    double ap = 0.0;
    double guessing = 0.0;
    for (std::size_t w = 0; w < validation.size(); ++w) {
      const SequenceWalk& walk = validation[w];
      const std::vector<Window> windows = ValidationWindows(walk, w);
      std::vector<std::invoke_result_t<Describe, const SequenceWalk&, const Window&>> described;
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
    const auto count = static_cast<double>(validation.size());
    Measures measures;
    measures("loss", 1.0 - ap / count);
    measures("ap", ap / count);
    measures("guessing", guessing / count);
    return measures;
  }

  MainDirections Directions() {
    sim::Rng rng(config.seed, "seqvlad directions");
    std::vector<torch::Tensor> rows;
    for (int i = 0; i < kDirectionWindows; ++i) {
      const SequenceWalk& walk = rng.Pick(train);
      const Window window = WindowOf(walk, rng.Between(config.shortest, config.longest), &rng);
      rows.push_back(net.forward(CellsOf(walk, {&window, 1})));
    }
    return MainDirectionsOf(at::cat(rows), config.model.size);
  }

  SeqVladTrainConfig config;
  std::vector<SequenceWalk> train;
  std::vector<SequenceWalk> validation;
  SeqVladNet net;
};

void SeqVladTrainConfig::Validate() const {
  TrainPlan::Validate();
  internal::RequireAtLeast(0, walk_scenes, "walk_scenes");
  internal::RequireAtLeast(1, walks, "walks");
  internal::RequireAtLeast(50, frames, "frames");
  internal::RequireAtLeast(1, shortest, "shortest");
  internal::RequireAtLeast(shortest, longest, "longest");
  internal::RequireAtLeast(1, queries, "queries");
  internal::RequireAtLeast(1, negatives, "negatives");
  if (!(margin > 0.0)) throw sim::KeyError("margin", "margin must be positive");
  if (2 * longest >= frames) throw sim::KeyError("longest", "longest must be below half of frames");
}

SeqVladTraining::SeqVladTraining(const Config& config, const TrainContext& context)
    : SeqVladTraining(config,
                      Walks(DataOf(config), config.walk_scenes, config.walks, config, context),
                      Walks(ValidationOf(config), 0, 1, config, context)) {}

SeqVladTraining::SeqVladTraining(const Config& config, std::vector<SequenceWalk> train,
                                 std::vector<SequenceWalk> validation)
    : work_(std::make_unique<Work>(config, std::move(train), std::move(validation))) {}

SeqVladTraining::~SeqVladTraining() = default;

torch::nn::Module& SeqVladTraining::net() {
  return work_->net;
}

double SeqVladTraining::Learn(const TrainStep& step) {
  agent::StayInThisThread();
  const torch::Tensor loss = work_->LossOf(step.step);
  loss.backward();
  const auto value = loss.item<double>();
  if (std::isfinite(value)) step.optimiser->Step(step.rate);
  return value;
}

Measures SeqVladTraining::Validate() {
  const torch::NoGradGuard no_grad;
  agent::StayInThisThread();
  return work_->MeasuresOf(
      [this](const SequenceWalk& walk, const Window& window) {
        return work_->net.forward(work_->CellsOf(walk, {&window, 1}));
      },
      [](const torch::Tensor& a, const torch::Tensor& b) {
        return (a * b).sum().item<double>();
      });
}

std::int64_t SeqVladTraining::FramesAfter(int steps) const {
  return std::int64_t{steps} * work_->config.queries * (2 + work_->config.negatives);
}

void SeqVladTraining::Save(std::map<std::string, std::string> notes,
                           const std::filesystem::path& file) const {
  const torch::NoGradGuard no_grad;
  agent::StayInThisThread();
  SaveSeqVlad(work_->net, work_->Directions(), std::move(notes), file);
}

std::optional<Measures> SeqVladTraining::Quantise(const std::filesystem::path& file) {
  const auto model = agent::LoadSeqVlad(file);
  return work_->MeasuresOf(
      [&](const SequenceWalk& walk, const Window& window) {
        agent::SequenceModel::Sum sum;
        model->Add(walk.Frames(window.first, window.count), &sum);
        return model->Describe(sum);
      },
      [](const agent::PictureDescriptor& a, const agent::PictureDescriptor& b) {
        return agent::Cosine(a, b);
      });
}

std::string SeqVladTraining::Describe(const Measures& m) const {
  return fmt::format("AP of sequences {:.3f} (guessing {:.3f})", m.at("ap"), m.at("guessing"));
}

namespace {

const TrainerRegistration<SeqVladTraining> registration;

}  // namespace
}  // namespace bulletnav::bench
