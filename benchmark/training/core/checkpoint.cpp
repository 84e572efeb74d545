// SPDX-License-Identifier: MIT
#include "benchmark/training/core/checkpoint.h"

#include <bit>
#include <charconv>
#include <cmath>
#include <string>
#include <system_error>
#include <utility>

#include "agent/perception/weights.h"
#include "benchmark/base/first_difference.h"
#include "benchmark/base/warn_line.h"
#include "sim/base/error.h"
#include "sim/base/files.h"
#include "sim/base/temporary_folder.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;

constexpr const char* kWeights = "model.";

/// An integer that was written into the file's metadata.
template <class T>
T Number(const agent::TensorFile& content, const std::string& key, const fs::path& file) {
  const auto found = content.metadata.find(key);
  T value{};
  if (found != content.metadata.end()) {
    const char* end = found->second.data() + found->second.size();
    const auto [stop, error] = std::from_chars(found->second.data(), end, value);
    if (error == std::errc() && stop == end) return value;
  }
  throw sim::FileError(file, key, "is missing: this is not a checkpoint; remove it");
}

agent::TensorFile ReadCheckpoint(const fs::path& file) {
  try {
    return agent::ReadTensorFile(file);
  } catch (const sim::FileError& e) {
    throw sim::Error(std::string(e.what()) + ", or remove the folder's checkpoints to begin anew");
  }
}

}  // namespace

Checkpoints::Checkpoints(const fs::path& folder, std::string essence, Peers* peers)
    : peers_(peers),
      newest_(folder / kCheckpointFile),
      previous_(folder / "checkpoint_previous.safetensors"),
      essence_(std::move(essence)) {}

void Checkpoints::Write(const TrainState& state, Training* training,
                        const Optimiser& optimiser) const {
  agent::TensorFile content;
  training->AppendState(&content);
  if (!peers_->is_first()) return;
  content.metadata["config"] = essence_;
  content.metadata["step"] = std::to_string(state.step);
  content.metadata["seconds"] = std::to_string(std::llround(state.seconds));
  content.metadata["best_loss_bits"] =
      std::to_string(std::bit_cast<std::uint64_t>(state.best_loss));
  agent::AppendWeights(training->net(), kWeights, &content);
  optimiser.Append(&content);
  std::error_code none_yet;
  fs::rename(newest_, previous_, none_yet);
  agent::WriteTensorFile(newest_, content);
}

std::optional<Checkpoints::Found> Checkpoints::Find() const {
  if (!fs::exists(newest_) && !fs::exists(previous_)) return std::nullopt;
  if (fs::exists(newest_)) {
    try {
      return Found{newest_, ReadCheckpoint(newest_)};
    } catch (const sim::Error& error) {
      if (!fs::exists(previous_)) throw;
      WarnLine(std::string(error.what()) + "; going on from " + previous_.string());
    }
  }
  return Found{previous_, ReadCheckpoint(previous_)};
}

/// What the first process finds goes to all, which may be on machines without its folder.
std::optional<Checkpoints::Found> Checkpoints::FindTogether() const {
  std::optional<Found> found;
  std::string bytes;
  if (peers_->is_first()) {
    found = Find();
    if (found) {
      const std::vector<std::uint8_t> read = sim::ReadFile(found->file);
      bytes.assign(read.begin(), read.end());
    }
  }
  bytes = peers_->FromFirst(bytes);
  if (peers_->is_first() || bytes.empty()) return found;
  const sim::TemporaryFolder folder;
  const fs::path copy = folder.path() / newest_.filename();
  sim::WriteFileAtomically(copy, bytes);
  return Found{newest_, ReadCheckpoint(copy)};
}

std::optional<TrainState> Checkpoints::Read(Training* training, Optimiser* optimiser) const {
  const std::optional<Found> found = peers_->size() == 1 ? Find() : FindTogether();
  if (!found) return std::nullopt;
  return Restore(found->file, found->content, training, optimiser);
}

TrainState Checkpoints::Restore(const fs::path& file, const agent::TensorFile& content,
                                Training* training, Optimiser* optimiser) const {
  const auto config = content.metadata.find("config");
  const std::string before = config == content.metadata.end() ? "" : config->second;
  if (before != essence_) {
    throw sim::FileError(file, "",
                         "is of a training by another config: " +
                             FirstDifference(before, essence_) + "; change out or remove it");
  }
  TrainState state;
  state.step = Number<int>(content, "step", file);
  state.best_loss = std::bit_cast<double>(Number<std::uint64_t>(content, "best_loss_bits", file));
  if (content.metadata.contains("seconds")) {
    state.seconds = static_cast<double>(Number<std::int64_t>(content, "seconds", file));
  }
  agent::SetWeights(content, kWeights, file, &training->net());
  optimiser->Set(content, file);
  training->SetState(content, file);
  return state;
}

}  // namespace bulletnav::bench
