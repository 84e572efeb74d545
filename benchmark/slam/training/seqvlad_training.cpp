// SPDX-License-Identifier: MIT
#include "benchmark/slam/training/seqvlad_training.h"

#include <algorithm>
#include <utility>

#include "agent/perception/one_thread.h"
#include "agent/slam/descriptors/seqvlad.h"
#include "sim/base/error.h"
#include "sim/math/rng.h"

namespace bulletnav::bench {
namespace {

constexpr int kStartCells = 20'000;      // that clusters are begun from
constexpr int kDirectionWindows = 1200;  // that principal components are of

}  // namespace

void SeqVladTrainConfig::Validate() const {
  SequencePlan::Validate();
  internal::RequireAtLeast(1, shortest, "shortest");
  internal::RequireAtLeast(shortest, longest, "longest");
  if (2 * longest >= frames) throw sim::KeyError("longest", "longest must be below half of frames");
}

SeqVladTraining::SeqVladTraining(const Config& config, const TrainContext& context)
    : SeqVladTraining(config, MakeWalks(config, context)) {}

SeqVladTraining::SeqVladTraining(const Config& config, SequenceWalks walks)
    : SequenceTraining(config, {config.shortest, config.longest}, std::string(kName),
                       std::move(walks)),
      config_(config),
      net_(config.model, config.seed) {
  const SequenceWalks& all = SequenceTraining::walks();
  for (const auto* some : {&all.train, &all.validation}) {
    for (const SequenceWalk& walk : *some) {
      if (walk.frame_bytes % static_cast<std::size_t>(config.model.channels) == 0) continue;
      throw sim::KeyError("model", "the model's channels are not those of the descriptor's cells");
    }
  }
  sim::Rng rng(config.seed, "seqvlad start");
  net_.StartFrom(SomeCells(&rng), &rng);
}

/// Cells of frames at random, rows of length 1.
Eigen::MatrixXf SeqVladTraining::SomeCells(sim::Rng* rng) const {
  Eigen::MatrixXf cells(kStartCells, config_.model.channels);
  const auto channels = static_cast<std::size_t>(config_.model.channels);
  for (int row = 0; row < kStartCells; ++row) {
    const SequenceWalk& walk = rng->Pick(walks().train);
    const auto count = static_cast<int>(walk.cells.size() / channels);
    const auto at = static_cast<std::size_t>(rng->Below(count)) * channels;
    for (std::size_t i = 0; i < channels; ++i) {
      cells(row, static_cast<Eigen::Index>(i)) = static_cast<float>(walk.cells[at + i]);
    }
    cells.row(row) /= std::max(1.0f, cells.row(row).norm());
  }
  return cells;
}

torch::Tensor SeqVladTraining::CellsOf(const SequenceWalk& walk,
                                       std::span<const Window> windows) const {
  std::vector<std::uint8_t> bytes;
  for (const Window& window : windows) {
    const auto some = walk.Frames(window.first, window.count);
    bytes.insert(bytes.end(), some.begin(), some.end());
  }
  return CellDirections(bytes, static_cast<int>(windows.size()), config_.model.channels);
}

torch::Tensor SeqVladTraining::DescribeWindows(const SequenceWalk& walk,
                                               std::span<const Window> windows) {
  return net_.forward(CellsOf(walk, windows));
}

MainDirections SeqVladTraining::Directions() const {
  sim::Rng rng(config_.seed, "seqvlad directions");
  std::vector<torch::Tensor> rows;
  for (int i = 0; i < kDirectionWindows; ++i) {
    const SequenceWalk& walk = rng.Pick(walks().train);
    const Window window = DrawWindow(walk, &rng);
    rows.push_back(net_.forward(CellsOf(walk, {&window, 1})));
  }
  return MainDirectionsOf(at::cat(rows), config_.model.size);
}

void SeqVladTraining::SaveNet(std::map<std::string, std::string> notes,
                              const std::filesystem::path& file) const {
  SaveSeqVlad(net_, Directions(), std::move(notes), file);
}

std::optional<Measures> SeqVladTraining::Quantise(const std::filesystem::path& file) {
  const auto model = agent::LoadSeqVlad(file);
  return MeasuresOf([&](const SequenceWalk& walk, const Window& window) {
    agent::SequenceModel::Sum sum;
    model->Add(walk.Frames(window.first, window.count), &sum);
    return model->Describe(sum);
  });
}

namespace {

const TrainerRegistration<SeqVladTraining> registration;

}  // namespace
}  // namespace bulletnav::bench
