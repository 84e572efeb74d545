// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "agent/slam/pose_graph/pose_graph.h"

namespace bulletnav::agent {

/// Odometry from vertex 0 to the last: poses one after the other, and how unsure any is as seen
/// from any other. Each step has an error of its own, and all share one, as of a wheel that is a
/// little too small, which grows with the way instead of with its square root.
template <class Pose>
class OdometryChain {
 public:
  using Spread = Eigen::Matrix<double, kFreedoms<Pose>, 1>;

  /// Standard deviations of the shared error, a step; as PoseEdge's error.
  explicit OdometryChain(const Spread& shared = Spread::Zero());
  /// The next vertex as measured from the last; covariance as of PoseEdge's error.
  void Add(const Pose& step, const PoseMatrix<Pose>& covariance);

  int size() const { return static_cast<int>(poses_.size()); }
  /// Pose of vertex `to` seen from vertex `from`, and its covariance to first order; either may be
  /// the earlier one. Cost: constant.
  Pose Seen(int from, int to) const;
  PoseMatrix<Pose> Covariance(int from, int to) const;

 private:
  Spread shared_;
  std::vector<Pose> poses_;               // seen from vertex 0
  std::vector<PoseMatrix<Pose>> unsure_;  // of the steps up to a vertex, all carried to vertex 0
  std::vector<PoseMatrix<Pose>> drift_;   // likewise, what a unit of each shared error does
};

/// How far the circle "loop a, odometry, loop b backwards, odometry" is from closing: squared
/// Mahalanobis distance, chi-squared with as many degrees as Pose has freedoms if both loops are
/// right. Edges name vertices by their place in the chain.
/// Source: Mangelson et al., "Pairwise consistent measurement set maximization", ICRA 2018.
template <class Pose>
double CircleError(const OdometryChain<Pose>& odometry, const PoseEdge<Pose>& a,
                   const PoseEdge<Pose>& b);

/// How far a loop is from where odometry alone has its ends: squared Mahalanobis distance, likewise
/// chi-squared if the loop is right. The loop's vertices are in the chain (checked).
template <class Pose>
double OdometryError(const OdometryChain<Pose>& odometry, const PoseEdge<Pose>& loop);

/// What wrong loops name that verification lets through: any motion as far and turned as far.
struct WrongMotions {
  double metres = 2.0;
  double radians = sim::kPi / 3.0;
};

/// The share of wrong loops between the same two vertices that odometry would rule out no more than
/// it does this one, between 0 and 1: small where odometry is sure and the loop says the same.
/// Ours; the idea of counting what agrees by chance is that of Desolneux, Moisan and Morel,
/// "Meaningful alignments", IJCV 2000. The loop's vertices are in the chain (checked).
double AgreesByChance(const OdometryChain<sim::PlanarPose>& odometry,
                      const PoseEdge<sim::PlanarPose>& loop, const WrongMotions& wrong);

/// How many of some loops support each other: more than `gap` apart from each other at both their
/// first and their second ends, which are places in the chain. Loops near each other at one end may
/// all be wrong together, as where two rooms are furnished alike. By greedy growth from each loop;
/// never too many, and 2 if any two are that far apart. Cost: pairs of loops times the result.
int SeparateLoops(std::span<const std::pair<int, int>> ends, int gap);

/// How long a larger set is looked for; whichever ends first, the best so far is kept.
struct SearchLimits {
  std::int64_t steps = 1'000'000;
  std::int64_t words = 20'000'000'000;  // of rows of an Agreement that are gone through: seconds
};

struct LoopSetOptions {
  /// Circles of right loops that are taken for right.
  double confidence = 0.99;
  SearchLimits search = {};
};

/// A largest set of things that agree pairwise.
struct ConsistentSet {
  std::vector<int> members;  // rising
  bool is_largest = false;   // proven: the search came to its end
};

/// Which things agree with which: symmetric, as bits.
class Agreement {
 public:
  explicit Agreement(int size);
  void Set(int a, int b);
  bool Has(int a, int b) const;
  int size() const { return size_; }
  /// 64 things a word.
  std::span<const std::uint64_t> Row(int a) const;

 private:
  int size_ = 0;
  std::size_t words_ = 0;
  std::vector<std::uint64_t> bits_;
};

/// By greedy growth from every thing, then branch and bound with colours until the limits are
/// reached. Cost: greedy n^2 words of n / 64; the search may go to its limits.
/// Source: Tomita and Kameda, "An efficient branch-and-bound algorithm for finding a maximum
/// clique", 2007.
ConsistentSet LargestAgreeing(const Agreement& agreement, const SearchLimits& limits);

/// The largest set of loops each two of which agree given odometry: wrong loops seldom agree with
/// right ones, or with each other. The members are positions in `loops`.
/// Cost: circles of all pairs of loops. Throws sim::Error for a loop whose vertices are not in the
/// chain, or with trouble (see check_pose_graph.h), or a confidence outside (0, 1).
template <class Pose>
ConsistentSet ConsistentLoops(const OdometryChain<Pose>& odometry,
                              std::span<const PoseEdge<Pose>> loops, const LoopSetOptions& options);

/// The value that a chi-squared variable stays below with probability p. Expects: 3 or 6 degrees of
/// freedom (checked).
double ChiSquaredQuantile(double p, int degrees);

}  // namespace bulletnav::agent
