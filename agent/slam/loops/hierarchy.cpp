// SPDX-License-Identifier: MIT
#include "agent/slam/loops/hierarchy.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "agent/slam/topology/clusters.h"
#include "sim/base/error.h"

namespace bulletnav::agent {
namespace {

/// A row a frame.
Eigen::MatrixXf Points(const DescriptorFrames& frames) {
  const auto columns = static_cast<Eigen::Index>(frames.descriptor(0).size());
  Eigen::MatrixXf points(frames.size(), columns);
  for (int frame = 0; frame < frames.size(); ++frame) {
    for (Eigen::Index i = 0; i < columns; ++i) {
      points(frame, i) = static_cast<float>(frames.descriptor(frame)[static_cast<std::size_t>(i)]) /
                         kDescriptorUnit;
    }
  }
  return points;
}

}  // namespace

void SequenceMatchSpec::Validate() const {
  if (!(sequence_weight >= 0.0 && sequence_weight <= 1.0)) {
    throw sim::Error("sequence_weight must lie between 0 and 1");
  }
  odometry.Validate();
}

void HierarchyConfig::Validate() const {
  match.Validate();
  if (window < 0 || !(window_weight >= 0.0 && window_weight + match.sequence_weight <= 1.0)) {
    throw sim::Error(
        "window must be at least 0, and window_weight and sequence_weight at most 1 together");
  }
  if (!(cluster_multiple > 0.0 && cluster_multiple <= 10.0)) {
    throw sim::Error("cluster_multiple must lie above 0 and at most at 10");
  }
  if (starts < 1 || shortest < 1 || most_clusters < 2 || length < 0) {
    throw sim::Error(
        "starts and shortest must be at least 1, most_clusters at least 2, length at least 0");
  }
}

namespace {

double WindowPart(const DescribedSequences& described, int later, int earlier) {
  if (described.windows == nullptr) return 0.0;
  return described.window_weight * described.windows->Best(later, earlier);
}

}  // namespace

std::optional<double> JoinedCosine(std::size_t later, std::size_t earlier,
                                   const DescribedSequences& described,
                                   const SequenceMatchSpec& spec) {
  const std::vector<Sequence>& sequences = described.sequences;
  if (spec.within_clusters && sequences[earlier].cluster != sequences[later].cluster) {
    return std::nullopt;
  }
  const double cosine = Cosine(described.wholes[earlier], described.wholes[later]);
  if (cosine < spec.least_sequence) return std::nullopt;
  return cosine;
}

void CompareInSequences(int frame, std::size_t own, const DescriptorFrames& frames,
                        const DescribedSequences& described, const SequenceMatchSpec& spec,
                        std::vector<LoopCandidate>* candidates) {
  const std::vector<Sequence>& sequences = described.sequences;
  const std::size_t first = candidates->size();
  for (std::size_t i = 0; i <= own; ++i) {
    const int end = std::min(sequences[i].last + 1, frames.comparable(frame));
    if (end <= sequences[i].first) continue;
    const std::optional<double> alike = JoinedCosine(own, i, described, spec);
    if (!alike) continue;
    for (int earlier = sequences[i].first; earlier < end; ++earlier) {
      const double cosine = Cosine(frames.descriptor(frame), frames.descriptor(earlier));
      const double score = (1.0 - spec.sequence_weight - described.window_weight) * cosine +
                           spec.sequence_weight * *alike + WindowPart(described, frame, earlier);
      const double against = frames.odometry().Against(frame, earlier, spec.odometry);
      candidates->push_back({frame, earlier, score - against, false});
    }
  }
  ProposeBest(first, spec.least_frame, candidates);
}

std::vector<Sequence> CutSequences(const std::vector<Sequence>& sequences, int length) {
  std::vector<Sequence> pieces;
  for (const Sequence& sequence : sequences) {
    for (int first = sequence.first; first <= sequence.last; first += length) {
      pieces.push_back({first, std::min(first + length - 1, sequence.last), sequence.cluster});
    }
  }
  return pieces;
}

HierarchyDetector::HierarchyDetector(std::string_view name, const HierarchyConfig& config,
                                     const LoopContext& context)
    : config_(config), frames_(name, context), model_(context.sequences) {
  if (!config_.seqvlad || model_) return;
  throw sim::Error("the detector '" + std::string(name) +
                   "' needs a descriptor of sequences; add 'sequences', a file of weights, to the "
                   "config, or set 'seqvlad' to false");
}

std::vector<LoopCandidate> HierarchyDetector::Add(const LoopFrame& frame) {
  frames_.Add(frame);
  return {};
}

std::vector<PictureDescriptor> HierarchyDetector::WholesOf(
    const std::vector<Sequence>& sequences) const {
  std::vector<PictureDescriptor> wholes;
  wholes.reserve(sequences.size());
  for (const Sequence& sequence : sequences) {
    if (config_.seqvlad) {
      SequenceModel::Sum sum;
      model_->Add(frames_.Cells(sequence.first, sequence.last), &sum);
      wholes.push_back(model_->Describe(sum));
    } else {
      wholes.push_back(MeanDirection(std::span(frames_.descriptors())
                                         .subspan(static_cast<std::size_t>(sequence.first),
                                                  static_cast<std::size_t>(sequence.size()))));
    }
  }
  return wholes;
}

std::vector<LoopCandidate> HierarchyDetector::Finish() {
  std::vector<LoopCandidate> candidates;
  if (frames_.size() == 0) return candidates;
  sim::Rng rng(config_.seed, "clusters");
  const Clusters clusters = ClusterByElbow(Points(frames_),
                                           {.most = config_.most_clusters,
                                            .starts = config_.starts,
                                            .multiple = config_.cluster_multiple},
                                           &rng);
  std::vector<Sequence> sequences = SequencesOf(clusters.group, config_.shortest);
  if (config_.length > 0) sequences = CutSequences(sequences, config_.length);
  const std::vector<PictureDescriptor> wholes = WholesOf(sequences);
  DescribedSequences described{sequences, wholes};
  std::optional<FrameWindows> windows;
  if (config_.window_weight > 0.0) {
    described.windows = &windows.emplace(frames_, config_.window);
    described.window_weight = config_.window_weight;
  }
  trace_ = {sequences, clusters.tried, clusters.spreads, {}};
  for (std::size_t own = 0; own < sequences.size(); ++own) {
    for (std::size_t i = 0; i < own; ++i) {
      if (!JoinedCosine(own, i, described, config_.match)) continue;
      trace_.joined.emplace_back(static_cast<int>(own), static_cast<int>(i));
    }
    for (int frame = sequences[own].first; frame <= sequences[own].last; ++frame) {
      CompareInSequences(frame, own, frames_, described, config_.match, &candidates);
    }
  }
  return candidates;
}

}  // namespace bulletnav::agent
