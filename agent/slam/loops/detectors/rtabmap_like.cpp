// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

#include "agent/slam/features/gftt.h"
#include "agent/slam/loops/loop_registry.h"
#include "agent/slam/loops/place_filter.h"
#include "agent/slam/retrieval/growing_words.h"
#include "agent/slam/verify/verify_loop.h"
#include "sim/base/error.h"

namespace bulletnav::agent {
namespace {

/// Loops as RTAB-Map finds them: words that are learned on the way, how like each earlier frame is
/// by their frequency, and a Bayes filter over all of them and a new place; the likeliest place is
/// proposed from a probability on. Beside it frames that odometry has near by, looking the same
/// way. It is not RTAB-Map: no memory that forgets, no poses of an optimised graph, frames of the
/// last metres are never compared, and loops are not told back.
/// Source: Labbe and Michaud, "RTAB-Map as an open-source lidar and visual SLAM library", JFR 2019,
/// and the settings of its release; the filter is in place_filter.h.
class RtabmapLike final : public LoopDetector {
 public:
  static constexpr std::string_view kName = "rtabmap_like";

  struct Config {
    bool own_corners = true;  // GFTT; else the ORB corners that all detectors share
    GfttSpec gftt;
    double word_ratio = 0.8;  // NNDR
    int short_term = 10;      // frames that are too new to be a place
    PlaceFilterSpec filter;
    double least_probability = 0.11;
    double proximity_m = 10.0;  // 0: no loops by odometry
    double proximity_deg = 45.0;
    int proximity_paths = 3;    // stretches of the way of which the nearest frame is proposed
    bool native_gates = false;  // propose only what its own verification accepts
    int inliers = 20;           // of that
    double pixels = 2.0;
    int iterations = 300;

    template <class V>
    void Visit(V& v) {
      v("own_corners", own_corners);
      v("gftt", gftt);
      v("word_ratio", word_ratio);
      v("short_term", short_term);
      v("filter", filter);
      v("least_probability", least_probability);
      v("proximity_m", proximity_m);
      v("proximity_deg", proximity_deg);
      v("proximity_paths", proximity_paths);
      v("native_gates", native_gates);
      v("inliers", inliers);
      v("pixels", pixels);
      v("iterations", iterations);
    }
    void Validate() const {
      if (short_term < 0 || proximity_paths < 0) {
        throw sim::Error("short_term and proximity_paths must not be negative");
      }
      if (!(least_probability > 0.0 && proximity_m >= 0.0 && proximity_deg >= 0.0)) {
        throw sim::Error(
            "least_probability must be positive, proximity_m and proximity_deg not negative");
      }
      if (!(word_ratio > 0.0 && word_ratio <= 1.0)) {
        throw sim::Error("word_ratio must be above 0 and at most 1");
      }
      GatesOf(*this).Validate();
    }
  };

  RtabmapLike(const Config& config, const LoopContext& /*context*/)
      : config_(config),
        words_(GrowingWordsSpec{.ratio = config.word_ratio}),
        filter_(config.filter) {}

  std::vector<LoopCandidate> Add(const LoopFrame& frame) override {
    Place& place = places_.emplace_back();
    place.odometry = frame.odometry;
    OrbFeatures features =
        config_.own_corners ? FindGftt(frame.color, frame.width_px, frame.height_px, config_.gftt)
                            : *frame.features;
    Count(words_.Take(features.descriptors));
    const int known = std::min(frame.comparable, std::max(0, frame.number - config_.short_term));
    const std::vector<double> likeness = LikenessOf(known);
    filter_.Update(likeness);
    std::vector<LoopCandidate> candidates;
    candidates.reserve(likeness.size());
    for (int earlier = 0; earlier < known; ++earlier) {
      const double probability = filter_.places()[static_cast<std::size_t>(earlier)];
      candidates.push_back({frame.number, earlier, probability, false});
    }
    KeepForGates(frame, std::move(features));
    ProposeLikeliest(&candidates);
    ProposeNear(&candidates);
    if (config_.native_gates) DropUnverified(frame, &candidates);
    return candidates;
  }

 private:
  struct Place {
    sim::PlanarPose odometry;
    int words = 0;
    OrbFeatures features;  // where gates need them, as the depths
    std::vector<float> depths;
  };

  static VerifySpec GatesOf(const Config& config) {
    VerifySpec gates;
    gates.ratio = config.word_ratio;
    gates.inliers = config.inliers;
    gates.pixels = config.pixels;
    gates.iterations = config.iterations;
    return gates;
  }

  /// Puts the last place's words into the index.
  void Count(const std::vector<int>& words) {
    const int number = static_cast<int>(places_.size()) - 1;
    places_.back().words = static_cast<int>(words.size());
    by_word_.resize(static_cast<std::size_t>(words_.size()));
    last_words_.clear();
    for (const int word : words) ++last_words_[word];
    for (const auto& [word, count] : last_words_) {
      by_word_[static_cast<std::size_t>(word)].emplace_back(number, count);
    }
  }

  /// By the frame's words' frequency in each of the first places, times the logarithm of how rare
  /// they are.
  std::vector<double> LikenessOf(int known) const {
    std::vector<double> likeness(static_cast<std::size_t>(known), 0.0);
    const auto all = static_cast<double>(places_.size());
    for (const auto& [word, mine] : last_words_) {
      const auto& having = by_word_[static_cast<std::size_t>(word)];
      const double rarity = std::log10(all / static_cast<double>(having.size()));
      for (const auto& [place, count] : having) {
        if (place >= known) break;  // they came in order
        const auto at = static_cast<std::size_t>(place);
        likeness[at] += count * rarity / places_[at].words;
      }
    }
    return likeness;
  }

  void ProposeLikeliest(std::vector<LoopCandidate>* candidates) const {
    const auto best = std::max_element(candidates->begin(), candidates->end(),
                                       [](const LoopCandidate& a, const LoopCandidate& b) {
                                         return a.score < b.score;
                                       });
    if (best == candidates->end()) return;
    best->is_proposed = best->score >= config_.least_probability;
  }

  /// Of each stretch of frames that odometry has near by and turned alike the nearest one.
  void ProposeNear(std::vector<LoopCandidate>* candidates) const {
    struct Near {
      double metres;
      std::size_t place;
    };
    std::vector<Near> paths;
    std::size_t last = 0;
    for (std::size_t i = 0; i < candidates->size(); ++i) {
      const sim::PlanarPose seen =
          sim::Compose(sim::Inverse(places_.back().odometry), places_[i].odometry);
      const double metres = std::hypot(seen.x, seen.y);
      const double turned = std::abs(sim::WrapAngle(seen.yaw));
      if (metres > config_.proximity_m || turned > sim::DegToRad(config_.proximity_deg)) continue;
      if (paths.empty() || i > last + 1) paths.push_back({metres, i});
      if (metres < paths.back().metres) paths.back() = {metres, i};
      last = i;
    }
    std::stable_sort(paths.begin(), paths.end(), [](const Near& a, const Near& b) {
      return a.metres < b.metres;
    });
    const auto most = static_cast<std::size_t>(config_.proximity_paths);
    if (config_.proximity_m > 0.0) {
      for (std::size_t i = 0; i < std::min(most, paths.size()); ++i) {
        (*candidates)[paths[i].place].is_proposed = true;
      }
    }
  }

  void KeepForGates(const LoopFrame& frame, OrbFeatures features) {
    if (!config_.native_gates || frame.depth.empty()) return;
    places_.back().depths = DepthsAt(frame.depth, frame.width_px, frame.height_px, features);
    places_.back().features = std::move(features);
  }

  void DropUnverified(const LoopFrame& frame, std::vector<LoopCandidate>* candidates) const {
    const Pinhole& camera = frame.flat_camera("'native_gates' of 'rtabmap_like'");
    const Place& now = places_.back();
    for (LoopCandidate& candidate : *candidates) {
      if (!candidate.is_proposed) continue;
      const Place& then = places_[static_cast<std::size_t>(candidate.earlier)];
      candidate.is_proposed =
          !now.depths.empty() && FindMotion({&then.features, then.depths},
                                            {&now.features, now.depths}, camera, GatesOf(config_))
                                     .has_value();
    }
  }

  Config config_;
  GrowingWords words_;
  PlaceFilter filter_;
  std::vector<Place> places_;
  std::map<int, int> last_words_;                          // of the last place: word, how often
  std::vector<std::vector<std::pair<int, int>>> by_word_;  // place, how often
};

const LoopDetectorRegistration<RtabmapLike> registration;

}  // namespace
}  // namespace bulletnav::agent
