// SPDX-License-Identifier: MIT
#include "benchmark/slam/runs/drive_traces.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "sim/base/error.h"
#include "sim/base/files.h"
#include "sim/config/yaml_reader.h"
#include "sim/config/yaml_writer.h"

namespace bulletnav::bench {
namespace {

namespace fs = std::filesystem;

constexpr int kMostCells = 256;

/// Frames by cells of a square picture.
class Cells {
 public:
  explicit Cells(int frames) : frames_(std::max(1, frames)), side_(std::min(frames_, kMostCells)) {}

  int side() const { return side_; }
  int Of(int frame) const {
    return static_cast<int>(static_cast<std::int64_t>(frame) * side_ / frames_);
  }

 private:
  int frames_;
  int side_;
};

/// A trace as lists of numbers.
struct TraceFile {
  std::vector<int> first;  // of sequences
  std::vector<int> last;
  std::vector<int> cluster;
  std::vector<int> tried;
  std::vector<double> spreads;
  std::vector<int> joined_later;
  std::vector<int> joined_earlier;

  template <class V>
  void Visit(V& v) {
    v("first", first);
    v("last", last);
    v("cluster", cluster);
    v("tried", tried);
    v("spreads", spreads);
    v("joined_later", joined_later);
    v("joined_earlier", joined_earlier);
  }
  void Validate() const {
    if (first.size() != last.size() || first.size() != cluster.size() ||
        tried.size() != spreads.size() || joined_later.size() != joined_earlier.size()) {
      throw sim::Error("lists that belong together are not of one length; play the drive again");
    }
  }
};

fs::path TracePath(const fs::path& folder, const std::string& name) {
  return folder / (name + ".sequences.yaml");
}

}  // namespace

sim::Image SimilarityMatrix(std::span<const agent::LoopCandidate> named, int frames) {
  const Cells cells(frames);
  sim::Image matrix(cells.side(), cells.side(), 1);
  double best = 0.0;
  for (const agent::LoopCandidate& pair : named) best = std::max(best, pair.score);
  if (best <= 0.0) return matrix;
  for (const agent::LoopCandidate& pair : named) {
    const auto grey = static_cast<std::uint8_t>(std::max(0.0, 255.0 * pair.score / best));
    const int later = cells.Of(pair.later);
    const int earlier = cells.Of(pair.earlier);
    std::uint8_t& cell = *matrix.at(later, earlier);
    cell = std::max(cell, grey);
    *matrix.at(earlier, later) = cell;
  }
  return matrix;
}

sim::Image CovisibleMatrix(const LoopTruth& truth) {
  std::vector<agent::LoopCandidate> pairs;
  for (int later = 0; later < truth.frames(); ++later) {
    if (!truth.HasLoop(LoopKind::kCovisible, later)) continue;
    for (int earlier = 0; earlier < truth.compared(later); ++earlier) {
      if (!truth.Is(LoopKind::kCovisible, later, earlier)) continue;
      pairs.push_back({later, earlier, 1.0, false});
    }
  }
  return SimilarityMatrix(pairs, truth.frames());
}

void WriteTrace(const fs::path& folder, const std::string& name,
                const agent::SequenceTrace& trace) {
  if (trace.sequences.empty()) return;
  TraceFile file;
  for (const agent::Sequence& sequence : trace.sequences) {
    file.first.push_back(sequence.first);
    file.last.push_back(sequence.last);
    file.cluster.push_back(sequence.cluster);
  }
  file.tried = trace.tried;
  file.spreads = trace.spreads;
  for (const auto& [later, earlier] : trace.joined) {
    file.joined_later.push_back(later);
    file.joined_earlier.push_back(earlier);
  }
  sim::WriteFileAtomically(TracePath(folder, name), sim::ToYaml(file));
}

agent::SequenceTrace ReadTrace(const fs::path& folder, const std::string& name) {
  agent::SequenceTrace trace;
  if (!fs::exists(TracePath(folder, name))) return trace;
  const auto file = sim::LoadYaml<TraceFile>(TracePath(folder, name));
  for (std::size_t i = 0; i < file.first.size(); ++i) {
    trace.sequences.push_back({file.first[i], file.last[i], file.cluster[i]});
  }
  trace.tried = file.tried;
  trace.spreads = file.spreads;
  for (std::size_t i = 0; i < file.joined_later.size(); ++i) {
    trace.joined.emplace_back(file.joined_later[i], file.joined_earlier[i]);
  }
  return trace;
}

}  // namespace bulletnav::bench
