// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <deque>
#include <utility>
#include <vector>

#include "agent/slam/loops/descriptor_frames.h"
#include "agent/slam/loops/loop_registry.h"
#include "agent/slam/loops/odometry_prior.h"
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
    /// Ours: a score is the mean over so many frames up to the later one, and as many around the
    /// earlier one. 1: of the pair alone.
    int window = 3;
    OdometryPriorSpec odometry = {.odometry_reach_m = 3.0};  // ours; how far a node reaches

    template <class V>
    void Visit(V& v) {
      v("least", least);
      v("window", window);
      odometry.Visit(v);
    }
    void Validate() const {
      odometry.Validate();
      if (!(least >= 0.0 && least <= 1.0)) throw sim::Error("least must be in [0, 1]");
      if (window < 1 || window % 2 == 0) throw sim::Error("window must be odd and positive");
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
    rows_.push_back(Ask(*frame.code, frame.comparable));
    if (static_cast<int>(rows_.size()) > config_.window) rows_.pop_front();
    codes_.push_back(*frame.code);
    track_.Add(frame.odometry);
    std::vector<LoopCandidate> candidates;
    candidates.reserve(static_cast<std::size_t>(frame.comparable));
    for (int earlier = 0; earlier < frame.comparable; ++earlier) {
      const double against = track_.Against(frame.number, earlier, config_.odometry);
      candidates.push_back({frame.number, earlier, Mean(earlier) - against, false});
    }
    ProposeBest(0, config_.least, &candidates);
    return candidates;
  }

 private:
  /// What F_L says of a frame and each of the first `comparable`, added up: entry k is of the first
  /// k of them.
  std::vector<double> Ask(const PanoramaCode& code, int comparable) {
    std::vector<double> sums = {0.0};
    if (comparable == 0) return sums;
    std::vector<const PanoramaCode*> earlier;
    earlier.reserve(static_cast<std::size_t>(comparable));
    for (int i = 0; i < comparable; ++i) earlier.push_back(&codes_[static_cast<std::size_t>(i)]);
    sums.reserve(earlier.size() + 1);
    for (const PairPrediction& said : places_->Compare(earlier, code)) {
      sums.push_back(sums.back() + double{said.same_node});
    }
    return sums;
  }

  /// Over the last rows, and over `window` of the earlier frames.
  double Mean(int earlier) const {
    double sum = 0.0;
    int count = 0;
    for (const std::vector<double>& row : rows_) {
      const int size = static_cast<int>(row.size()) - 1;
      const int first = std::max(0, earlier - config_.window / 2);
      const int end = std::min(size, earlier + config_.window / 2 + 1);
      if (first >= end) continue;
      sum += row[static_cast<std::size_t>(end)] - row[static_cast<std::size_t>(first)];
      count += end - first;
    }
    return sum / count;
  }

  Config config_;
  std::shared_ptr<SemanticModel> places_;
  std::vector<PanoramaCode> codes_;  // by frame
  OdometryTrack track_;
  std::deque<std::vector<double>> rows_;  // of Ask, of the last frames
};

const LoopDetectorRegistration<SameNode> registration;

}  // namespace
}  // namespace bulletnav::agent
