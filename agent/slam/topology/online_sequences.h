// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "agent/slam/retrieval/picture_descriptor.h"
#include "agent/slam/topology/sequences.h"

namespace bulletnav::agent {

struct OnlineClusterSpec {
  double least_like = 0.6;  // cosine with the nearest cluster's mean; below it a new one begins
  double stay = 0.05;       // that another cluster must be nearer than the one it is in
  int shortest = 3;         // frames of a sequence; shorter ones join the one before

  template <class V>
  void Visit(V& v) {
    v("least_like", least_like);
    v("stay", stay);
    v("shortest", shortest);
  }
  /// Throws sim::Error.
  void Validate() const;
};

/// Clusters and sequences of frames as they come: what is known at a frame depends on no later one.
/// A frame joins the cluster whose mean is nearest, rather the one before it was in, or begins one.
/// Runs of one cluster are sequences, described by their mean. Ours, in place of K-means over the
/// whole drive.
class OnlineSequences {
 public:
  explicit OnlineSequences(const OnlineClusterSpec& spec) : spec_(spec) {}

  void Add(const PictureDescriptor& frame);

  int clusters() const { return static_cast<int>(centres_.size()); }
  /// Of all frames so far, in order; the last one goes on.
  const std::vector<Sequence>& sequences() const { return sequences_; }
  /// Their means, one for one.
  const std::vector<PictureDescriptor>& wholes() const { return wholes_; }

 private:
  using Sum = std::vector<std::int64_t>;

  int ClusterOf(const PictureDescriptor& frame) const;
  void Join(const PictureDescriptor& frame, int cluster);
  /// Takes the last sequence into the one before it.
  void MergeLast();

  OnlineClusterSpec spec_;
  std::vector<Sum> centre_sums_;
  std::vector<PictureDescriptor> centres_;
  std::vector<Sequence> sequences_;
  std::vector<Sum> sums_;  // of sequences
  std::vector<PictureDescriptor> wholes_;
  int frames_ = 0;
};

}  // namespace bulletnav::agent
