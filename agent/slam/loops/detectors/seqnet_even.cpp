// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <vector>

#include "agent/slam/loops/descriptor_frames.h"
#include "agent/slam/loops/loop_registry.h"
#include "sim/base/error.h"

namespace bulletnav::agent {
namespace {

/// SeqNet's hierarchy: the sequence that ends with a frame finds those most like it by one
/// descriptor each, and of these alone pictures are compared, one by one in order. SeqNet describes
/// sequences by a learned filter over time; here it is even, since none is trained. Source: Garg
/// and Milford, "SeqNet: learning descriptors for sequence-based hierarchical place recognition",
/// RA-L 2021.
class SeqNetEven final : public LoopDetector {
 public:
  static constexpr std::string_view kName = "seqnet_even";

  struct Config {
    int length = 5;            // frames of a sequence
    int shortlist = 50;        // sequences whose pictures are compared
    double least_frame = 0.5;  // mean cosine of pictures

    template <class V>
    void Visit(V& v) {
      v("length", length);
      v("shortlist", shortlist);
      v("least_frame", least_frame);
    }
    void Validate() const {
      if (length < 1 || shortlist < 1) {
        throw sim::Error("length and shortlist must be at least 1");
      }
    }
  };

  SeqNetEven(const Config& config, const LoopContext& context)
      : config_(config), frames_(kName, context) {}

  std::vector<LoopCandidate> Add(const LoopFrame& frame) override {
    frames_.Add(frame);
    sequences_.push_back(MeanOfLast(frames_, config_.length));
    std::vector<LoopCandidate> candidates =
        CompareWithAll(frame.number, frame.comparable, sequences_, 2.0);
    Shorten(&candidates);
    for (LoopCandidate& candidate : candidates) {
      candidate.score = OrderedCosine(frames_, candidate.later, candidate.earlier, config_.length);
    }
    ProposeBest(0, config_.least_frame, &candidates);
    return candidates;
  }

 private:
  /// The most alike, the earlier of equals.
  void Shorten(std::vector<LoopCandidate>* candidates) const {
    const auto most = static_cast<std::size_t>(config_.shortlist);
    if (candidates->size() <= most) return;
    const auto is_before = [](const LoopCandidate& a, const LoopCandidate& b) {
      return a.score != b.score ? a.score > b.score : a.earlier < b.earlier;
    };
    std::partial_sort(candidates->begin(), candidates->begin() + config_.shortlist,
                      candidates->end(), is_before);
    candidates->resize(most);
  }

  Config config_;
  DescriptorFrames frames_;
  std::vector<PictureDescriptor> sequences_;  // that end with each frame
};

const LoopDetectorRegistration<SeqNetEven> registration;

}  // namespace
}  // namespace bulletnav::agent
