// SPDX-License-Identifier: MIT
#include "agent/slam/pose_graph/loop_sets.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <string>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "agent/slam/pose_graph/check_pose_graph.h"
#include "sim/base/check.h"
#include "sim/base/error.h"

namespace bulletnav::agent {
namespace {

/// Carries a small difference at B, seen from A, to A; of numbers as PoseEdge's error has them.
PoseMatrix<sim::PlanarPose> Carrier(const sim::PlanarPose& X_AB) {
  const double c = std::cos(X_AB.yaw);
  const double s = std::sin(X_AB.yaw);
  PoseMatrix<sim::PlanarPose> carrier;
  carrier << c, -s, X_AB.y, s, c, -X_AB.x, 0.0, 0.0, 1.0;
  return carrier;
}

PoseMatrix<SpatialPose> Carrier(const SpatialPose& X_AB) {
  const Eigen::Matrix3d turn = X_AB.rotation.toRotationMatrix();
  const Eigen::Vector3d& p = X_AB.position;
  Eigen::Matrix3d cross;
  cross << 0.0, -p.z(), p.y(), p.z(), 0.0, -p.x(), -p.y(), p.x(), 0.0;
  PoseMatrix<SpatialPose> carrier;
  carrier << turn, cross * turn, Eigen::Matrix3d::Zero(), turn;
  return carrier;
}

template <class Pose>
PoseMatrix<Pose> Carried(const Pose& X_AB, const PoseMatrix<Pose>& covariance) {
  const PoseMatrix<Pose> carrier = Carrier(X_AB);
  return carrier * covariance * carrier.transpose();
}

Eigen::Vector3d NumbersOf(const sim::PlanarPose& pose) {
  return {pose.x, pose.y, pose.yaw};
}

Eigen::Matrix<double, 6, 1> NumbersOf(const SpatialPose& pose) {
  Eigen::Matrix<double, 6, 1> numbers;
  numbers << pose.position, RotationVector(pose.rotation);
  return numbers;
}

template <class Pose>
void CheckLoop(const PoseEdge<Pose>& loop, std::size_t position, int chain) {
  const std::string name = "loop " + std::to_string(position + 1) + " from " +
                           std::to_string(loop.from) + " to " + std::to_string(loop.to);
  for (const std::int64_t end : {loop.from, loop.to}) {
    if (end < 0 || end >= chain) {
      throw sim::Error(name + ": odometry has no vertex " + std::to_string(end) +
                       "; leave the loop out");
    }
  }
  if (const auto trouble = Trouble(loop)) throw sim::Error(name + ": " + *trouble);
}

/// Of chi-squared with 3 or 6 degrees of freedom, which have closed forms.
double ChiSquaredBelow(double x, int degrees) {
  const double half = x / 2.0;
  if (degrees == 3) {
    return std::erf(std::sqrt(half)) - 2.0 * std::sqrt(half / sim::kPi) * std::exp(-half);
  }
  return 1.0 - std::exp(-half) * (1.0 + half + half * half / 2.0);
}

}  // namespace

template <class Pose>
OdometryChain<Pose>::OdometryChain(const Spread& shared)
    : shared_(shared),
      poses_(1),
      unsure_(1, PoseMatrix<Pose>::Zero()),
      drift_(1, PoseMatrix<Pose>::Zero()) {}

template <class Pose>
void OdometryChain<Pose>::Add(const Pose& step, const PoseMatrix<Pose>& covariance) {
  poses_.push_back(Compose(poses_.back(), step));
  unsure_.push_back(unsure_.back() + Carried(poses_.back(), covariance));
  drift_.push_back(drift_.back() + Carrier(poses_.back()));
}

template <class Pose>
Pose OdometryChain<Pose>::Seen(int from, int to) const {
  return Compose(Inverse(poses_[static_cast<std::size_t>(from)]),
                 poses_[static_cast<std::size_t>(to)]);
}

template <class Pose>
PoseMatrix<Pose> OdometryChain<Pose>::Covariance(int from, int to) const {
  const auto low = static_cast<std::size_t>(std::min(from, to));
  const auto high = static_cast<std::size_t>(std::max(from, to));
  const PoseMatrix<Pose> drift = (drift_[high] - drift_[low]) * shared_.asDiagonal();
  return Carried<Pose>(Inverse(poses_[static_cast<std::size_t>(to)]),
                       unsure_[high] - unsure_[low] + drift * drift.transpose());
}

template <class Pose>
double CircleError(const OdometryChain<Pose>& odometry, const PoseEdge<Pose>& a,
                   const PoseEdge<Pose>& b) {
  const auto a_from = static_cast<int>(a.from);
  const auto a_to = static_cast<int>(a.to);
  const auto b_from = static_cast<int>(b.from);
  const auto b_to = static_cast<int>(b.to);
  const Pose over = Compose(a.measured, odometry.Seen(a_to, b_to));
  const Pose circle = Compose(over, Compose(Inverse(b.measured), odometry.Seen(b_from, a_from)));
  const PoseMatrix<Pose> at_b = b.information.inverse() + odometry.Covariance(a_to, b_to);
  const PoseMatrix<Pose> covariance = Carried<Pose>(a.measured, a.information.inverse()) +
                                      Carried<Pose>(over, at_b) +
                                      Carried<Pose>(circle, odometry.Covariance(b_from, a_from));
  const auto error = NumbersOf(circle);
  return error.dot(covariance.llt().solve(error));
}

namespace {

/// A loop and odometry back: how far from closing, squared, and how unsure.
template <class Pose>
struct Circle {
  double error = 0.0;
  PoseMatrix<Pose> covariance;
};

template <class Pose>
Circle<Pose> CircleOf(const OdometryChain<Pose>& odometry, const PoseEdge<Pose>& loop) {
  const auto from = static_cast<int>(loop.from);
  const auto to = static_cast<int>(loop.to);
  BULLETNAV_CHECK(std::min(from, to) >= 0 && std::max(from, to) < odometry.size());
  const Pose motion = Compose(loop.measured, odometry.Seen(to, from));
  const PoseMatrix<Pose> covariance = Carried<Pose>(loop.measured, loop.information.inverse()) +
                                      Carried<Pose>(motion, odometry.Covariance(to, from));
  const auto error = NumbersOf(motion);
  return {error.dot(covariance.llt().solve(error)), covariance};
}

}  // namespace

template <class Pose>
double OdometryError(const OdometryChain<Pose>& odometry, const PoseEdge<Pose>& loop) {
  return CircleOf(odometry, loop).error;
}

double AgreesByChance(const OdometryChain<sim::PlanarPose>& odometry,
                      const PoseEdge<sim::PlanarPose>& loop, const WrongMotions& wrong) {
  const Circle<sim::PlanarPose> circle = CircleOf(odometry, loop);
  // An ellipsoid of motions that err as much, in a cylinder of all.
  const double ellipsoid = 4.0 / 3.0 * sim::kPi * circle.error * std::sqrt(circle.error) *
                           std::sqrt(circle.covariance.determinant());
  const double all = sim::kPi * wrong.metres * wrong.metres * 2.0 * wrong.radians;
  return std::min(1.0, ellipsoid / all);
}

int SeparateLoops(std::span<const std::pair<int, int>> ends, int gap) {
  using Ends = std::pair<int, int>;
  const auto is_apart_of_all = [gap](const Ends& other, const std::vector<Ends>& those) {
    return std::all_of(those.begin(), those.end(), [&](const Ends& one) {
      return std::abs(one.first - other.first) > gap && std::abs(one.second - other.second) > gap;
    });
  };
  std::size_t most = 0;
  for (const Ends& first : ends) {
    std::vector<Ends> apart = {first};
    for (const Ends& other : ends) {
      if (is_apart_of_all(other, apart)) apart.push_back(other);
    }
    most = std::max(most, apart.size());
  }
  return static_cast<int>(most);
}

template <class Pose>
ConsistentSet ConsistentLoops(const OdometryChain<Pose>& odometry,
                              std::span<const PoseEdge<Pose>> loops,
                              const LoopSetOptions& options) {
  if (!(options.confidence > 0.0 && options.confidence < 1.0)) {
    throw sim::Error("the confidence of consistent loops must lie between 0 and 1");
  }
  for (std::size_t i = 0; i < loops.size(); ++i) CheckLoop(loops[i], i, odometry.size());
  const double limit = ChiSquaredQuantile(options.confidence, kFreedoms<Pose>);
  Agreement agreement(static_cast<int>(loops.size()));
  for (int i = 0; i < agreement.size(); ++i) {
    for (int j = 0; j < i; ++j) {
      const auto& first = loops[static_cast<std::size_t>(i)];
      const auto& second = loops[static_cast<std::size_t>(j)];
      if (CircleError(odometry, first, second) <= limit) agreement.Set(i, j);
    }
  }
  return LargestAgreeing(agreement, options.search);
}

double ChiSquaredQuantile(double p, int degrees) {
  BULLETNAV_CHECK(degrees == 3 || degrees == 6);
  double low = 0.0;
  double high = 1000.0;
  for (int i = 0; i < 100; ++i) {
    const double middle = (low + high) / 2.0;
    (ChiSquaredBelow(middle, degrees) < p ? low : high) = middle;
  }
  return low;
}

template class OdometryChain<sim::PlanarPose>;
template double OdometryError(const OdometryChain<sim::PlanarPose>&,
                              const PoseEdge<sim::PlanarPose>&);
template double CircleError(const OdometryChain<sim::PlanarPose>&, const PoseEdge<sim::PlanarPose>&,
                            const PoseEdge<sim::PlanarPose>&);
template ConsistentSet ConsistentLoops(const OdometryChain<sim::PlanarPose>&,
                                       std::span<const PoseEdge<sim::PlanarPose>>,
                                       const LoopSetOptions&);
template class OdometryChain<SpatialPose>;
template double OdometryError(const OdometryChain<SpatialPose>&, const PoseEdge<SpatialPose>&);
template double CircleError(const OdometryChain<SpatialPose>&, const PoseEdge<SpatialPose>&,
                            const PoseEdge<SpatialPose>&);
template ConsistentSet ConsistentLoops(const OdometryChain<SpatialPose>&,
                                       std::span<const PoseEdge<SpatialPose>>,
                                       const LoopSetOptions&);

}  // namespace bulletnav::agent
