// SPDX-License-Identifier: MIT
#include <cmath>

#include "agent/slam/loops/descriptor_frames.h"
#include "agent/slam/loops/loop_registry.h"
#include "sim/base/error.h"

namespace bulletnav::agent {
namespace {

/// Every frame against all earlier ones, by the descriptors of their pictures: what hierarchies are
/// compared with. Source: Sharma et al., "Hierarchical Unsupervised Topological SLAM", 2023,
/// section IV-C; GeM of Radenovic, Tolias and Chum, TPAMI 2018.
class GemFlat final : public LoopDetector {
 public:
  static constexpr std::string_view kName = "gem_flat";

  struct Config {
    double least_frame = 0.3;    // t_g, cosine of two frames
    OdometryPriorSpec odometry;  // ours; the paper's has none

    template <class V>
    void Visit(V& v) {
      v("least_frame", least_frame);
      odometry.Visit(v);
    }
    void Validate() const {
      odometry.Validate();
      if (!std::isfinite(least_frame)) throw sim::Error("least_frame must be a number");
    }
  };

  GemFlat(const Config& config, const LoopContext& context)
      : config_(config), frames_(kName, context) {}

  std::vector<LoopCandidate> Add(const LoopFrame& frame) override {
    frames_.Add(frame);
    std::vector<LoopCandidate> candidates =
        ScoreAll(frame.number, frame.comparable, frames_.descriptors());
    for (LoopCandidate& candidate : candidates) {
      candidate.score -=
          frames_.odometry().Against(candidate.later, candidate.earlier, config_.odometry);
    }
    ProposeBest(0, config_.least_frame, &candidates);
    return candidates;
  }

 private:
  Config config_;
  DescriptorFrames frames_;
};

const LoopDetectorRegistration<GemFlat> registration;

}  // namespace
}  // namespace bulletnav::agent
