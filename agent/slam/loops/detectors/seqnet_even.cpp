// SPDX-License-Identifier: MIT
#include <span>

#include "agent/slam/loops/loop_registry.h"
#include "agent/slam/loops/seqnet_hierarchy.h"
#include "sim/base/error.h"

namespace bulletnav::agent {
namespace {

/// SeqNet's hierarchy with a filter over time that is even instead of learned: sequences are
/// described by the mean of their pictures' descriptors.
class SeqNetEven final : public SeqNetHierarchy {
 public:
  static constexpr std::string_view kName = "seqnet_even";

  struct Config : SeqNetSpec {
    int length = 5;  // frames of a sequence

    template <class V>
    void Visit(V& v) {
      v("length", length);
      SeqNetSpec::Visit(v);
    }
    void Validate() const {
      SeqNetSpec::Validate();
      if (length < 1) throw sim::KeyError("length", "length must be at least 1");
    }
  };

  SeqNetEven(const Config& config, const LoopContext& context)
      : SeqNetHierarchy(kName, config, config.length, context) {}

 private:
  PictureDescriptor DescribeSequence(std::span<const PictureDescriptor> frames) const override {
    return MeanDirection(frames);
  }
};

const LoopDetectorRegistration<SeqNetEven> registration;

}  // namespace
}  // namespace bulletnav::agent
