// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

namespace bulletnav::agent {

/// Consecutive frames of one cluster, both ends included.
struct Sequence {
  int first = 0;
  int last = 0;
  int cluster = 0;

  int size() const { return last - first + 1; }
};

/// The runs of frames of one cluster, in order; together they are all frames. Runs shorter than
/// `shortest` join the one before them, at the start the one after; 1 keeps all as they are.
/// Source: Sharma et al., "Hierarchical Unsupervised Topological SLAM", 2023, section III-A; that
/// short runs join is ours.
std::vector<Sequence> SequencesOf(std::span<const int> clusters, int shortest);

}  // namespace bulletnav::agent
