// SPDX-License-Identifier: MIT
#include <vector>

#include "agent/slam/loops/descriptor_frames.h"
#include "agent/slam/loops/loop_registry.h"

namespace bulletnav::agent {
namespace {

/// The mean descriptor of the last few frames against that of all earlier ones: sequences of fixed
/// length, described by a filter over time that is even and not learned. Source of the form: Garg
/// and Milford, "SeqNet: learning descriptors for sequence-based hierarchical place recognition",
/// RA-L 2021, whose filter is learned.
class GemMean final : public LoopDetector {
 public:
  static constexpr std::string_view kName = "gem_mean";

  using Config = FixedSequences;

  GemMean(const Config& config, const LoopContext& context)
      : config_(config), frames_(kName, context) {}

  std::vector<LoopCandidate> Add(const LoopFrame& frame) override {
    frames_.Add(frame);
    means_.push_back(MeanDirection(frames_.Last(config_.length)));
    return CompareWithAll(frame.number, frame.comparable, means_, config_.least_frame);
  }

 private:
  Config config_;
  DescriptorFrames frames_;
  std::vector<PictureDescriptor> means_;  // of what ends with each frame
};

const LoopDetectorRegistration<GemMean> registration;

}  // namespace
}  // namespace bulletnav::agent
