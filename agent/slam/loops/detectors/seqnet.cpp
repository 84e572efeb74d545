// SPDX-License-Identifier: MIT
#include <memory>
#include <span>
#include <string>

#include "agent/slam/loops/loop_registry.h"
#include "agent/slam/loops/seqnet_hierarchy.h"
#include "sim/base/error.h"

namespace bulletnav::agent {
namespace {

/// SeqNet's hierarchy with its learned filter over time, as long as that filter.
class SeqNet final : public SeqNetHierarchy {
 public:
  static constexpr std::string_view kName = "seqnet";
  using Config = SeqNetSpec;

  SeqNet(const Config& config, const LoopContext& context)
      : SeqNetHierarchy(kName, config, LengthOf(context), context), filter_(context.filter) {}

 private:
  static int LengthOf(const LoopContext& context) {
    if (context.descriptor_size == 0) return 1;  // frames say what is missing
    const std::string name = "the detector '" + std::string(kName) + "'";
    if (!context.filter) {
      throw sim::Error(name +
                       " needs a filter over time; add 'filter', a file of weights, to the config "
                       "(train one with configs/train/seqnet.yaml), or take 'seqnet_even'");
    }
    if (context.filter->size() != context.descriptor_size) {
      throw sim::Error(name + ": 'filter' is of descriptors of " +
                       std::to_string(context.filter->size()) +
                       " numbers, and 'descriptors' have " +
                       std::to_string(context.descriptor_size) + "; they belong together");
    }
    return context.filter->length();
  }

  PictureDescriptor DescribeSequence(std::span<const PictureDescriptor> frames) const override {
    return filter_->Describe(frames);
  }

  std::shared_ptr<const SequenceFilter> filter_;
};

const LoopDetectorRegistration<SeqNet> registration;

}  // namespace
}  // namespace bulletnav::agent
