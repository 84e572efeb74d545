// SPDX-License-Identifier: MIT
#include "agent/slam/loops/hierarchy.h"
#include "agent/slam/loops/loop_registry.h"
#include "agent/slam/topology/online_sequences.h"

namespace bulletnav::agent {
namespace {

/// The hierarchy of sequences and frames with clusters that grow as frames come, so that it answers
/// at each frame, as detectors that look at frames alone do. The last sequence is compared as far
/// as it has come. Ours; see HierarchyDetector for the paper's.
class HutOnline final : public LoopDetector {
 public:
  static constexpr std::string_view kName = "hut_online";

  struct Config {
    OnlineClusterSpec clusters;
    SequenceMatchSpec match;

    template <class V>
    void Visit(V& v) {
      clusters.Visit(v);
      match.Visit(v);
    }
    void Validate() const {
      clusters.Validate();
      match.Validate();
    }
  };

  HutOnline(const Config& config, const LoopContext& context)
      : config_(config), frames_(kName, context), sequences_(config.clusters) {}

  std::vector<LoopCandidate> Add(const LoopFrame& frame) override {
    frames_.Add(frame);
    sequences_.Add(frames_.descriptors().back());
    std::vector<LoopCandidate> candidates;
    const auto& sequences = sequences_.sequences();
    CompareInSequences(frame.number, sequences.size() - 1, frames_,
                       {sequences, sequences_.wholes()}, config_.match, &candidates);
    return candidates;
  }

 private:
  Config config_;
  DescriptorFrames frames_;
  OnlineSequences sequences_;
};

const LoopDetectorRegistration<HutOnline> registration;

}  // namespace
}  // namespace bulletnav::agent
