// SPDX-License-Identifier: MIT
#include "agent/slam/topology/sequences.h"

namespace bulletnav::agent {
namespace {

std::vector<Sequence> RunsOf(std::span<const int> clusters) {
  std::vector<Sequence> runs;
  for (int frame = 0; frame < static_cast<int>(clusters.size()); ++frame) {
    const int cluster = clusters[static_cast<std::size_t>(frame)];
    if (runs.empty() || runs.back().cluster != cluster) runs.push_back({frame, frame, cluster});
    runs.back().last = frame;
  }
  return runs;
}

}  // namespace

std::vector<Sequence> SequencesOf(std::span<const int> clusters, int shortest) {
  std::vector<Sequence> sequences;
  int waiting = -1;  // first of the frames at the start that no sequence has taken yet
  for (const Sequence& run : RunsOf(clusters)) {
    const bool is_short = run.size() < shortest;
    if (!sequences.empty() && (is_short || sequences.back().cluster == run.cluster)) {
      sequences.back().last = run.last;
    } else if (is_short) {
      if (waiting < 0) waiting = run.first;
    } else {
      sequences.push_back({waiting < 0 ? run.first : waiting, run.last, run.cluster});
      waiting = -1;
    }
  }
  // Nothing but short runs: one sequence.
  if (waiting >= 0) {
    sequences.push_back({waiting, static_cast<int>(clusters.size()) - 1, clusters.front()});
  }
  return sequences;
}

}  // namespace bulletnav::agent
