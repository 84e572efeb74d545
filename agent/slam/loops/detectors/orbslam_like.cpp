// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "agent/slam/loops/loop_registry.h"
#include "agent/slam/retrieval/word_index.h"
#include "agent/slam/verify/projected_matches.h"
#include "sim/base/error.h"

namespace bulletnav::agent {
namespace {

/// Loops as ORB-SLAM finds them: frames that share most words with the frame and are more like it
/// than the least like of its own neighbours; likeness is summed up over groups of covisible
/// frames; the best of the best groups are proposed once groups of some frames in a row overlap.
/// It is not ORB-SLAM: every frame is a keyframe, and as there is no map, frames are covisible that
/// are near in time and share words.
/// Source: Mur-Artal et al., "ORB-SLAM", T-RO 2015, section VII, and Campos et al., "ORB-SLAM3",
/// T-RO 2021, section VI; numbers are those of their releases.
class OrbslamLike final : public LoopDetector {
 public:
  static constexpr std::string_view kName = "orbslam_like";

  struct Config {
    int window = 20;            // frames before a frame that may be covisible with it
    int common_words = 15;      // that covisible frames share
    int group = 10;             // covisible frames, the most alike, whose likeness counts together
    double word_share = 0.8;    // of the most words in common, that a candidate has too
    int most_groups = 3;        // that are proposed
    int agreeing = 3;           // frames in a row whose groups overlap with the ones before
    bool native_gates = false;  // propose only what its own verification accepts
    int matches = 20;           // of that
    int first_inliers = 15;
    int inliers = 20;
    int wide_projected = 50;  // points of the group that are found within 8 pixels
    int projected = 80;       // and within 5
    int neighbours = 3;       // of the five frames before, that agree with the motion
    int neighbour_projected = 30;

    template <class V>
    void Visit(V& v) {
      v("window", window);
      v("common_words", common_words);
      v("group", group);
      v("word_share", word_share);
      v("most_groups", most_groups);
      v("agreeing", agreeing);
      v("native_gates", native_gates);
      v("matches", matches);
      v("first_inliers", first_inliers);
      v("inliers", inliers);
      v("wide_projected", wide_projected);
      v("projected", projected);
      v("neighbours", neighbours);
      v("neighbour_projected", neighbour_projected);
    }
    void Validate() const {
      if (window < 1 || common_words < 1 || group < 0 || most_groups < 1 || agreeing < 0) {
        throw sim::Error(
            "window, common_words and most_groups must be at least 1, group and agreeing at least "
            "0");
      }
      if (!(word_share >= 0.0 && word_share <= 1.0)) {
        throw sim::Error("word_share must lie between 0 and 1");
      }
      if (first_inliers < 4) throw sim::Error("first_inliers must be at least 4");
    }
  };

  OrbslamLike(const Config& config, const LoopContext& context)
      : config_(config), vocabulary_(context.vocabulary) {
    if (!vocabulary_) {
      throw sim::Error(
          "the detector 'orbslam_like' needs a vocabulary; add 'vocabulary' to the config");
    }
    index_.emplace(vocabulary_->words());
  }

  std::vector<LoopCandidate> Add(const LoopFrame& frame) override {
    Keyframe& now = Keep(frame);
    const double least = JoinNeighbours(frame.number);
    const std::vector<Likeness> alike =
        index_->MostLike(now.words, frame.comparable, frame.comparable);
    std::vector<LoopCandidate> candidates;
    candidates.reserve(alike.size());
    for (const Likeness& one : alike) {
      candidates.push_back({frame.number, one.picture, one.similarity, false});
    }
    index_->Add(now.words);
    std::vector<int> chosen;
    if (least > 0.0) chosen = BestOfGroups(alike, least);
    const std::set<int> agreed = Agreeing(chosen);
    const Pinhole* gate =
        config_.native_gates ? &frame.flat_camera("'native_gates' of 'orbslam_like'") : nullptr;
    for (LoopCandidate& candidate : candidates) {
      candidate.is_proposed = agreed.contains(candidate.earlier) &&
                              (gate == nullptr || PassesGates(candidate.earlier, *gate));
    }
    return candidates;
  }

 private:
  struct Keyframe {
    WordVector words;
    std::vector<std::pair<int, double>> covisible;  // frame, likeness
    sim::PlanarPose odometry;
    OrbFeatures features;  // where gates need them, as the depths
    std::vector<float> depths;
  };

  /// A group of frames about a candidate, and for how many frames in a row there was one there.
  struct Group {
    std::set<int> frames;
    int in_a_row = 0;
  };

  Keyframe& Keep(const LoopFrame& frame) {
    Keyframe& now = frames_.emplace_back();
    now.words = vocabulary_->Describe(frame.features->descriptors);
    now.odometry = frame.odometry;
    if (config_.native_gates && !frame.depth.empty()) {
      now.features = *frame.features;
      now.depths = DepthsAt(frame.depth, frame.width_px, frame.height_px, now.features);
    }
    return now;
  }

  static int CommonWords(const WordVector& a, const WordVector& b) {
    int common = 0;
    auto at = b.begin();
    for (const auto& [word, weight] : a) {
      while (at != b.end() && at->first < word) ++at;
      if (at == b.end()) break;
      if (at->first == word) ++common;
    }
    return common;
  }

  /// Finds the covisible frames of a new one; how like it the least like of them is, 0 of none.
  double JoinNeighbours(int number) {
    Keyframe& now = frames_[static_cast<std::size_t>(number)];
    double least = 0.0;
    for (int other = std::max(0, number - config_.window); other < number; ++other) {
      Keyframe& before = frames_[static_cast<std::size_t>(other)];
      if (CommonWords(now.words, before.words) < config_.common_words) continue;
      const double alike = Similarity(now.words, before.words);
      now.covisible.emplace_back(other, alike);
      before.covisible.emplace_back(number, alike);
      least = least == 0.0 ? alike : std::min(least, alike);
    }
    return least;
  }

  /// A frame with its most alike covisible ones.
  std::vector<int> GroupOf(int frame) const {
    auto covisible = frames_[static_cast<std::size_t>(frame)].covisible;
    std::stable_sort(covisible.begin(), covisible.end(), [](const auto& a, const auto& b) {
      return a.second > b.second;
    });
    std::vector<int> group = {frame};
    for (const auto& [other, alike] : covisible) {
      if (static_cast<int>(group.size()) > config_.group) break;
      group.push_back(other);
    }
    return group;
  }

  /// Those that share many words with the last frame and are like it enough.
  std::map<int, double> Eligible(const std::vector<Likeness>& alike, double least) const {
    int most = 0;
    for (const Likeness& one : alike) most = std::max(most, one.common_words);
    std::map<int, double> eligible;
    for (const Likeness& one : alike) {
      if (one.common_words < config_.word_share * most || one.similarity < least) continue;
      eligible.emplace(one.picture, one.similarity);
    }
    return eligible;
  }

  std::vector<int> BestOfGroups(const std::vector<Likeness>& all, double least) const {
    const std::map<int, double> eligible = Eligible(all, least);
    std::map<int, double> sums;  // by the best frame of a group
    for (const auto& [frame, alike] : eligible) {
      double sum = 0.0;
      int best = frame;
      for (const int member : GroupOf(frame)) {
        const auto found = eligible.find(member);
        if (found == eligible.end()) continue;
        sum += found->second;
        if (found->second > eligible.at(best)) best = member;
      }
      sums[best] = std::max(sums[best], sum);
    }
    std::vector<std::pair<int, double>> order(sums.begin(), sums.end());
    std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) {
      return a.second > b.second;
    });
    std::vector<int> best;
    for (const auto& [frame, sum] : order) {
      if (static_cast<int>(best.size()) == config_.most_groups) break;
      best.push_back(frame);
    }
    return best;
  }

  /// How many frames in a row before this one had a group that shares one of the members.
  int LongestBefore(const std::vector<int>& members) const {
    int longest = 0;
    for (const Group& before : last_groups_) {
      const bool overlaps = std::any_of(members.begin(), members.end(), [&](int member) {
        return before.frames.contains(member);
      });
      if (overlaps) longest = std::max(longest, before.in_a_row + 1);
    }
    return longest;
  }

  /// Those of the candidates whose groups have been there for long enough.
  std::set<int> Agreeing(const std::vector<int>& candidates) {
    std::vector<Group> groups;
    std::set<int> agreed;
    for (const int candidate : candidates) {
      const std::vector<int> members = GroupOf(candidate);
      Group& group = groups.emplace_back(Group{{members.begin(), members.end()}, 0});
      group.in_a_row = LongestBefore(members);
      if (group.in_a_row >= config_.agreeing) agreed.insert(candidate);
    }
    last_groups_ = std::move(groups);
    return agreed;
  }

  DepthCorners CornersOf(int frame) const {
    const Keyframe& kept = frames_[static_cast<std::size_t>(frame)];
    return {&kept.features, kept.depths};
  }

  /// The way of ORB-SLAM3 from matches over inliers and projections to agreeing neighbours.
  bool PassesGates(int earlier, const Pinhole& camera) const {
    const int later = static_cast<int>(frames_.size()) - 1;
    if (frames_.back().depths.empty()) return false;
    VerifySpec gates;
    gates.inliers = config_.first_inliers;
    const auto motion = FindMotion(CornersOf(earlier), CornersOf(later), camera, gates);
    if (!motion || motion->matches < config_.matches || motion->inliers < config_.inliers) {
      return false;
    }
    std::vector<GroupFrame> group;
    const sim::PlanarPose to_earlier =
        sim::Inverse(frames_[static_cast<std::size_t>(earlier)].odometry);
    for (const int member : GroupOf(earlier)) {
      group.push_back(
          {CornersOf(member),
           sim::Compose(to_earlier, frames_[static_cast<std::size_t>(member)].odometry)});
    }
    const OrbFeatures& now = frames_.back().features;
    constexpr double kWidePixels = 8.0;
    constexpr double kPixels = 5.0;
    ProjectionSpec spec;
    spec.pixels = kWidePixels;
    if (CountProjected(group, now, motion->X_AB, camera, spec) < config_.wide_projected) {
      return false;
    }
    spec.pixels = kPixels;
    if (CountProjected(group, now, motion->X_AB, camera, spec) < config_.projected) return false;
    return NeighboursAgree(group, motion->X_AB, camera);
  }

  /// Whether frames just before see the group too, where odometry has them from the last one.
  bool NeighboursAgree(const std::vector<GroupFrame>& group, const SpatialPose& X_AB,
                       const Pinhole& camera) const {
    constexpr int kNeighbours = 5;
    const int last = static_cast<int>(frames_.size()) - 1;
    const sim::PlanarPose to_last = sim::Inverse(frames_.back().odometry);
    int agreeing = 0;
    for (int other = last - 1; other >= 0 && other >= last - kNeighbours; --other) {
      const Keyframe& before = frames_[static_cast<std::size_t>(other)];
      const sim::PlanarPose from_last = sim::Compose(to_last, before.odometry);
      // The same of cameras: turned about y, which is down.
      const SpatialPose camera_pose = {Eigen::Vector3d(-from_last.y, 0.0, from_last.x),
                                       RotationBy(Eigen::Vector3d(0.0, -from_last.yaw, 0.0))};
      const int found =
          CountProjected(group, before.features, Compose(X_AB, camera_pose), camera, {});
      if (found >= config_.neighbour_projected) ++agreeing;
    }
    return agreeing >= config_.neighbours;
  }

  Config config_;
  std::shared_ptr<const Vocabulary> vocabulary_;
  std::optional<WordIndex> index_;
  std::vector<Keyframe> frames_;
  std::vector<Group> last_groups_;
};

const LoopDetectorRegistration<OrbslamLike> registration;

}  // namespace
}  // namespace bulletnav::agent
