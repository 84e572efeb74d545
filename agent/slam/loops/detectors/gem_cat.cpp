// SPDX-License-Identifier: MIT
#include "agent/slam/loops/descriptor_frames.h"
#include "agent/slam/loops/loop_registry.h"

namespace bulletnav::agent {
namespace {

/// The descriptors of the last few frames one after the other, as one long descriptor, against
/// those of all earlier frames. It knows the order of frames, and so the direction of travel.
/// Source: "GeM + CAT" in Mereu et al., "Learning sequential descriptors for sequence-based visual
/// place recognition", RA-L 2022; after Facil et al., 2019.
class GemCat final : public LoopDetector {
 public:
  static constexpr std::string_view kName = "gem_cat";

  using Config = FixedSequences;

  GemCat(const Config& config, const LoopContext& context)
      : config_(config), frames_(kName, context) {}

  std::vector<LoopCandidate> Add(const LoopFrame& frame) override {
    frames_.Add(frame);
    std::vector<LoopCandidate> candidates;
    candidates.reserve(static_cast<std::size_t>(frame.comparable));
    for (int earlier = 0; earlier < frame.comparable; ++earlier) {
      const double alike = OrderedCosine(frames_, frame.number, earlier, config_.length);
      candidates.push_back({frame.number, earlier, alike, false});
    }
    ProposeBest(0, config_.least_frame, &candidates);
    return candidates;
  }

 private:
  Config config_;
  DescriptorFrames frames_;
};

const LoopDetectorRegistration<GemCat> registration;

}  // namespace
}  // namespace bulletnav::agent
