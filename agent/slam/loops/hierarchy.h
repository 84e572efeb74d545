// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "agent/slam/loops/descriptor_frames.h"
#include "agent/slam/loops/frame_windows.h"
#include "agent/slam/topology/sequences.h"

namespace bulletnav::agent {

/// Which sequences are joined and which of their frames are loops.
struct SequenceMatchSpec {
  double least_sequence = 0.0;  // t_s, cosine of two sequences that are joined
  double least_frame = 0.3;     // t_g, cosine of two frames
  /// Of the sequences' cosine in a pair's score, the rest is the frames'. 0 is as the paper has it.
  double sequence_weight = 0.5;
  bool within_clusters = false;     // sequences of other clusters are never joined
  OdometryPriorSpec odometry = {};  // ours

  template <class V>
  void Visit(V& v) {
    v("least_sequence", least_sequence);
    v("least_frame", least_frame);
    v("sequence_weight", sequence_weight);
    v("within_clusters", within_clusters);
    odometry.Visit(v);
  }
  /// Throws sim::Error.
  void Validate() const;
};

/// Sequences and their descriptions, one for one.
struct DescribedSequences {
  const std::vector<Sequence>& sequences;
  const std::vector<PictureDescriptor>& wholes;
  const FrameWindows* windows = nullptr;  // of their frames, or none
  double window_weight = 0.0;             // of the windows in a pair's score
};

/// The cosine of sequence `earlier`, at most `later`, with that one if the two are joined.
std::optional<double> JoinedCosine(std::size_t later, std::size_t earlier,
                                   const DescribedSequences& described,
                                   const SequenceMatchSpec& spec);

/// Compares a frame with those frames before its `comparable` whose sequence is joined with its
/// own, which is number `own`; appends a candidate for each, and takes the best for a loop if it is
/// good enough. A sequence is joined with itself: a long one may come back.
void CompareInSequences(int frame, std::size_t own, const DescriptorFrames& frames,
                        const DescribedSequences& described, const SequenceMatchSpec& spec,
                        std::vector<LoopCandidate>* candidates);

/// Cuts each sequence into pieces of `length` frames; what is left over is a shorter one.
std::vector<Sequence> CutSequences(const std::vector<Sequence>& sequences, int length);

/// The settings of HierarchyDetector.
struct HierarchyConfig {
  int most_clusters = 60;
  int starts = 3;               // of clustering, for each number of clusters
  double cluster_multiple = 1;  // of the number of clusters at the elbow
  int shortest = 3;             // frames of a sequence; shorter ones join a neighbour. 1: they stay
  int length = 0;               // of the pieces that sequences are cut into; 0: they stay whole
  bool seqvlad = false;         // describe sequences by it, else by the mean of their descriptors
  int window = 2;               // frames on either side, see FrameWindows
  double window_weight = 0.45;  // of the best of two frames' windows in a pair's score. 0: none
  SequenceMatchSpec match{.sequence_weight = 0.1};
  std::uint64_t seed = 1;

  template <class V>
  void Visit(V& v) {
    v("most_clusters", most_clusters);
    v("starts", starts);
    v("cluster_multiple", cluster_multiple);
    v("shortest", shortest);
    v("length", length);
    v("seqvlad", seqvlad);
    v("window", window);
    v("window_weight", window_weight);
    match.Visit(v);
    v("seed", seed);
  }
  void Validate() const;
};

/// The second paper's hierarchy: all frames of the drive are clustered by their descriptors, the
/// number of clusters by the elbow; consecutive frames of a cluster are a sequence; sequences that
/// are alike as wholes, here by the mean of their descriptors, are joined; and only frames of
/// joined sequences are compared one by one. It needs the whole drive, so that it answers at its
/// end. Source: Sharma et al., "Hierarchical Unsupervised Topological SLAM", 2023, section III;
/// there sequences are described by SeqVLAD.
class HierarchyDetector : public LoopDetector {
 public:
  /// Throws sim::Error if frames have no descriptors, or SeqVLAD is wanted and not there.
  HierarchyDetector(std::string_view name, const HierarchyConfig& config,
                    const LoopContext& context);

  std::vector<LoopCandidate> Add(const LoopFrame& frame) override;
  std::vector<LoopCandidate> Finish() override;
  SequenceTrace Trace() const override { return trace_; }

 private:
  std::vector<PictureDescriptor> WholesOf(const std::vector<Sequence>& sequences) const;

  HierarchyConfig config_;
  DescriptorFrames frames_;
  std::shared_ptr<const SequenceModel> model_;
  SequenceTrace trace_;
};

}  // namespace bulletnav::agent
