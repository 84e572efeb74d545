// SPDX-License-Identifier: MIT
#include <utility>
#include <vector>

#include "agent/slam/loops/descriptor_frames.h"
#include "agent/slam/loops/loop_registry.h"
#include "sim/base/error.h"

namespace bulletnav::agent {
namespace {

/// Each panorama against all earlier ones by F_L, which Neural Topological SLAM decides with
/// whether two of them are of one node: the goal can be seen, within 3 m. Source: Chaplot et al.,
/// "Neural Topological SLAM for visual navigation", 2020, section 4.
class SameNode final : public LoopDetector {
 public:
  static constexpr std::string_view kName = "same_node";

  struct Config {
    double least = 0.9;  // probability

    template <class V>
    void Visit(V& v) {
      v("least", least);
    }
    void Validate() const {
      if (!(least >= 0.0 && least <= 1.0)) throw sim::Error("least must be in [0, 1]");
    }
  };

  SameNode(const Config& config, const LoopContext& context)
      : config_(config), places_(context.places) {
    if (places_) return;
    throw sim::Error(
        "the detector 'same_node' needs a semantic model; add 'panorama' and 'places', a file of "
        "weights, to the config");
  }

  std::vector<LoopCandidate> Add(const LoopFrame& frame) override {
    std::vector<const PanoramaCode*> earlier;
    earlier.reserve(static_cast<std::size_t>(frame.comparable));
    for (int i = 0; i < frame.comparable; ++i) {
      earlier.push_back(&codes_[static_cast<std::size_t>(i)]);
    }
    std::vector<LoopCandidate> candidates;
    if (!earlier.empty()) {
      for (const PairPrediction& said : places_->Compare(earlier, *frame.code)) {
        const int number = static_cast<int>(candidates.size());
        candidates.push_back({frame.number, number, double{said.same_node}, false});
      }
      ProposeBest(0, config_.least, &candidates);
    }
    codes_.push_back(*frame.code);
    return candidates;
  }

 private:
  Config config_;
  std::shared_ptr<SemanticModel> places_;
  std::vector<PanoramaCode> codes_;  // by frame
};

const LoopDetectorRegistration<SameNode> registration;

}  // namespace
}  // namespace bulletnav::agent
