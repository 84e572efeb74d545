// SPDX-License-Identifier: MIT
#include "agent/slam/pose_graph/loop_sets.h"

#include <bit>
#include <cmath>

#include <Eigen/LU>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/base/error.h"
#include "tests/agent/slam/pose_graph/random_graph.h"

namespace bulletnav::agent {
namespace {

using sim::PlanarPose;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;
using tests::Moved;
using tests::Numbers;
using tests::PoseVector;
using tests::RandomNumbers;

/// From tables.
TEST(ChiSquaredQuantile, IsThatOfTables) {
  EXPECT_NEAR(ChiSquaredQuantile(0.95, 3), 7.8147, 1e-4);
  EXPECT_NEAR(ChiSquaredQuantile(0.99, 3), 11.3449, 1e-4);
  EXPECT_NEAR(ChiSquaredQuantile(0.95, 6), 12.5916, 1e-4);
  EXPECT_NEAR(ChiSquaredQuantile(0.5, 6), 5.3481, 1e-4);
}

Agreement RandomAgreement(int size, double share, sim::Rng* rng) {
  Agreement agreement(size);
  for (int i = 0; i < size; ++i) {
    for (int j = 0; j < i; ++j) {
      if (rng->Chance(share)) agreement.Set(i, j);
    }
  }
  return agreement;
}

bool AllAgree(const Agreement& agreement, const std::vector<int>& members) {
  for (const int a : members) {
    for (const int b : members) {
      if (a != b && !agreement.Has(a, b)) return false;
    }
  }
  return true;
}

/// Tries all sets.
int LargestByTrial(const Agreement& agreement) {
  int largest = 0;
  for (std::uint32_t set = 0; set < (1u << agreement.size()); ++set) {
    std::vector<int> members;
    for (int i = 0; i < agreement.size(); ++i) {
      if ((set >> i & 1u) != 0) members.push_back(i);
    }
    if (static_cast<int>(members.size()) > largest && AllAgree(agreement, members)) {
      largest = static_cast<int>(members.size());
    }
  }
  return largest;
}

TEST(LargestAgreeing, IsThatOfTryingAll) {
  sim::Rng rng(1, "agreement");
  for (int trial = 0; trial < 40; ++trial) {
    const Agreement agreement = RandomAgreement(1 + trial % 14, rng.Uniform(), &rng);
    const ConsistentSet set = LargestAgreeing(agreement, {.steps = 1'000'000});
    EXPECT_TRUE(set.is_largest);
    EXPECT_TRUE(AllAgree(agreement, set.members));
    EXPECT_EQ(static_cast<int>(set.members.size()), LargestByTrial(agreement));
  }
}

TEST(LargestAgreeing, FindsAPlantedSetOfManyWords) {
  sim::Rng rng(2, "agreement");
  Agreement agreement = RandomAgreement(300, 0.3, &rng);
  std::vector<int> planted;
  for (int i = 0; i < 40; ++i) planted.push_back(7 * i + 3);
  for (const int a : planted) {
    for (const int b : planted) {
      if (a != b) agreement.Set(a, b);
    }
  }
  const ConsistentSet set = LargestAgreeing(agreement, {.steps = 1'000'000});
  EXPECT_TRUE(set.is_largest);
  EXPECT_EQ(set.members, planted);
}

TEST(LargestAgreeing, WithoutStepsIsGreedyAndSaysSo) {
  sim::Rng rng(3, "agreement");
  const Agreement agreement = RandomAgreement(120, 0.6, &rng);
  const ConsistentSet greedy = LargestAgreeing(agreement, {.steps = 0});
  EXPECT_FALSE(greedy.is_largest);
  EXPECT_GE(greedy.members.size(), 8u);
  EXPECT_TRUE(AllAgree(agreement, greedy.members));
  EXPECT_LE(greedy.members.size(), LargestAgreeing(agreement, {.steps = 100'000}).members.size());
}

/// A step costs the more, the more things there are.
TEST(LargestAgreeing, EndsWhenItsWordsAreUsedUp) {
  sim::Rng rng(4, "agreement");
  const Agreement agreement = RandomAgreement(400, 0.7, &rng);
  const ConsistentSet set = LargestAgreeing(agreement, {.words = 1'000'000});
  EXPECT_FALSE(set.is_largest);
  EXPECT_TRUE(AllAgree(agreement, set.members));
  EXPECT_GE(set.members.size(), LargestAgreeing(agreement, {.steps = 0}).members.size());
}

TEST(LargestAgreeing, OfNothingIsNothing) {
  EXPECT_TRUE(LargestAgreeing(Agreement(0), {}).members.empty());
  EXPECT_THAT(LargestAgreeing(Agreement(1), {}).members, ElementsAre(0));
}

template <class Pose>
class Loops : public ::testing::Test {};
using Poses = ::testing::Types<PlanarPose, SpatialPose>;
TYPED_TEST_SUITE(Loops, Poses);

/// Noise of covariance noise^2 * shape, shape with correlations.
template <class Pose>
class Noise {
 public:
  Noise(double size, sim::Rng* rng) : rng_(rng) {
    root_.setIdentity();
    for (double& number : root_.reshaped()) number += 0.3 * rng->Normal();
    root_ *= size;
  }
  Pose On(const Pose& pose) const {
    return Moved(pose, PoseVector<Pose>(root_ * RandomNumbers<Pose>(1.0, rng_)));
  }
  PoseMatrix<Pose> covariance() const { return root_ * root_.transpose(); }

 private:
  sim::Rng* rng_;
  PoseMatrix<Pose> root_;
};

template <class Pose>
Pose Between(const std::vector<Pose>& truth, int from, int to) {
  return Compose(Inverse(truth[static_cast<std::size_t>(from)]),
                 truth[static_cast<std::size_t>(to)]);
}

template <class Pose>
std::vector<Pose> Walk(int size, sim::Rng* rng) {
  std::vector<Pose> truth(1);
  while (static_cast<int>(truth.size()) < size) {
    truth.push_back(Moved(truth.back(), RandomNumbers<Pose>(0.5, rng)));
  }
  return truth;
}

template <class Pose>
OdometryChain<Pose> Measured(const std::vector<Pose>& truth, const Noise<Pose>& noise) {
  OdometryChain<Pose> odometry;
  for (int i = 1; i < static_cast<int>(truth.size()); ++i) {
    odometry.Add(noise.On(Between(truth, i - 1, i)), noise.covariance());
  }
  return odometry;
}

/// The covariance that is summed from the parts is that of many walks, both ways.
TYPED_TEST(Loops, CovarianceIsThatOfManyWalks) {
  sim::Rng rng(4, "walks");
  const auto truth = Walk<TypeParam>(12, &rng);
  const Noise<TypeParam> noise(0.002, &rng);
  constexpr int kWalks = 4000;
  for (const auto& [from, to] : {std::pair(2, 9), std::pair(9, 2)}) {
    PoseMatrix<TypeParam> seen = PoseMatrix<TypeParam>::Zero();
    PoseMatrix<TypeParam> said;
    for (int i = 0; i < kWalks; ++i) {
      const auto odometry = Measured(truth, noise);
      const auto error =
          Numbers(Compose(Inverse(Between(truth, from, to)), odometry.Seen(from, to)));
      seen += error * error.transpose() / kWalks;
      said = odometry.Covariance(from, to);
    }
    EXPECT_LT((seen - said).norm(), 0.12 * said.norm());
  }
}

/// Right loops fall below a quantile as often as it says.
TYPED_TEST(Loops, CircleErrorIsChiSquared) {
  sim::Rng rng(5, "circles");
  constexpr int kTrials = 4000;
  int below_half = 0;
  int below_95 = 0;
  const auto truth = Walk<TypeParam>(40, &rng);
  const Noise<TypeParam> step(0.002, &rng);
  const Noise<TypeParam> seen(0.01, &rng);
  const auto loop = [&](int from, int to) {
    return PoseEdge<TypeParam>{from, to, seen.On(Between(truth, from, to)),
                               seen.covariance().inverse(), true};
  };
  constexpr int kSize = kFreedoms<TypeParam>;
  for (int i = 0; i < kTrials; ++i) {
    const double error = CircleError(Measured(truth, step), loop(3, 30), loop(8, 37));
    below_half += error < ChiSquaredQuantile(0.5, kSize) ? 1 : 0;
    below_95 += error < ChiSquaredQuantile(0.95, kSize) ? 1 : 0;
  }
  EXPECT_NEAR(below_half, 0.5 * kTrials, 0.04 * kTrials);
  EXPECT_NEAR(below_95, 0.95 * kTrials, 0.02 * kTrials);
}

TYPED_TEST(Loops, WrongOnesAreLeftOut) {
  sim::Rng rng(6, "wrong");
  const auto truth = Walk<TypeParam>(100, &rng);
  const Noise<TypeParam> step(0.003, &rng);
  const Noise<TypeParam> seen(0.01, &rng);
  std::vector<PoseEdge<TypeParam>> loops;
  for (int i = 0; i < 40; ++i) {
    const int from = rng.Below(50);
    const int to = 50 + rng.Below(50);
    const bool is_wrong = i % 3 == 0;
    TypeParam measured = seen.On(Between(truth, from, to));
    if (is_wrong) measured = Moved(measured, RandomNumbers<TypeParam>(1.0, &rng));
    loops.push_back({from, to, measured, seen.covariance().inverse(), true});
  }
  const ConsistentSet set = ConsistentLoops<TypeParam>(Measured(truth, step), loops, {});
  EXPECT_TRUE(set.is_largest);
  EXPECT_GE(set.members.size(), 23u);  // of 26; a pair in a hundred fails by chance
  for (const int i : set.members) EXPECT_NE(i % 3, 0) << "loop " << i;
}

TEST(ConsistentLoops, TellsWhatIsWrong) {
  OdometryChain<PlanarPose> odometry;
  odometry.Add({1.0, 0.0, 0.0}, Eigen::Matrix3d::Identity());
  std::vector<PoseEdge<PlanarPose>> loops = {{0, 1, {}}, {0, 2, {}}};
  EXPECT_THAT(
      [&] {
        ConsistentLoops<PlanarPose>(odometry, loops, {});
      },
      ThrowsMessage<sim::Error>(HasSubstr("loop 2 from 0 to 2: odometry has no vertex 2")));
  loops.pop_back();
  loops[0].information.setZero();
  EXPECT_THAT(
      [&] {
        ConsistentLoops<PlanarPose>(odometry, loops, {});
      },
      ThrowsMessage<sim::Error>(HasSubstr("loop 1 from 0 to 1: the information is not")));
  EXPECT_THAT(
      [&] {
        ConsistentLoops<PlanarPose>(odometry, {}, {.confidence = 1.0});
      },
      ThrowsMessage<sim::Error>(HasSubstr("between 0 and 1")));
}

/// As another loop of no length at its first vertex, of which one is sure, has it.
TEST(OdometryError, IsTheCircleWithALoopThatSaysNothing) {
  OdometryChain<PlanarPose> chain;
  sim::Rng rng(7, "odometry");
  const PoseMatrix<PlanarPose> covariance = Eigen::Vector3d(1e-4, 2e-4, 1e-3).asDiagonal();
  for (int i = 0; i < 30; ++i) {
    chain.Add({rng.Uniform(0.0, 0.3), rng.Uniform(-0.1, 0.1), rng.Uniform(-0.3, 0.3)}, covariance);
  }
  PoseEdge<PlanarPose> loop;
  loop.from = 3;
  loop.to = 25;
  loop.measured = {0.2, -0.3, 0.4};
  loop.information = Eigen::Vector3d(400.0, 300.0, 900.0).asDiagonal();
  PoseEdge<PlanarPose> none;
  none.from = 3;
  none.to = 3;
  none.information = PoseMatrix<PlanarPose>::Identity() * 1e12;
  EXPECT_NEAR(OdometryError(chain, loop), CircleError(chain, loop, none), 1e-3);
  loop.measured = chain.Seen(3, 25);
  EXPECT_NEAR(OdometryError(chain, loop), 0.0, 1e-12);
}

/// Against loops drawn at random, a share of which errs no more.
TEST(AgreesByChance, IsTheShareOfWrongLoopsThatAgreeAsWell) {
  constexpr int kDrawn = 200'000;
  OdometryChain<PlanarPose> chain(Eigen::Vector3d(0.0, 0.0, 2e-3));
  sim::Rng rng(8, "chance");
  const PoseMatrix<PlanarPose> covariance = Eigen::Vector3d(1e-4, 2e-4, 3e-5).asDiagonal();
  for (int i = 0; i < 40; ++i) {
    chain.Add({0.2, rng.Uniform(-0.05, 0.05), rng.Uniform(-0.3, 0.3)}, covariance);
  }
  const PlanarPose said = chain.Seen(2, 37);
  PoseEdge<PlanarPose> loop;
  loop.from = 2;
  loop.to = 37;
  loop.information = Eigen::Vector3d(400.0, 400.0, 900.0).asDiagonal();
  loop.measured = sim::Compose(said, {0.15, -0.1, 0.05});
  const double error = OdometryError(chain, loop);
  const WrongMotions wrong = {.metres = 2.0, .radians = 0.8};
  const double share = AgreesByChance(chain, loop, wrong);
  int as_well = 0;
  for (int i = 0; i < kDrawn; ++i) {
    const double turned = rng.Uniform(-wrong.radians, wrong.radians);
    const double distance = wrong.metres * std::sqrt(rng.Uniform(0.0, 1.0));
    const double way = rng.Uniform(-sim::kPi, sim::kPi);
    PoseEdge<PlanarPose> other = loop;
    other.measured =
        sim::Compose(said, {distance * std::cos(way), distance * std::sin(way), turned});
    as_well += OdometryError(chain, other) <= error ? 1 : 0;
  }
  EXPECT_GT(as_well, 500);
  EXPECT_NEAR(share, static_cast<double>(as_well) / kDrawn, 0.1 * share);
  // What odometry says itself agrees best; what it rules out, all do as well.
  loop.measured = said;
  EXPECT_NEAR(AgreesByChance(chain, loop, wrong), 0.0, 1e-9);
  loop.measured = sim::Compose(said, {5.0, 5.0, 2.0});
  EXPECT_EQ(AgreesByChance(chain, loop, wrong), 1.0);
}

/// Straight on: a turn too much in every step, always the same, grows with the way in yaw and with
/// its square to the side.
TEST(OdometryChain, ASharedErrorAddsUp) {
  constexpr double kTurn = 1e-3;
  OdometryChain<PlanarPose> chain(Eigen::Vector3d(0.0, 0.0, kTurn));
  for (int i = 0; i < 20; ++i) chain.Add({0.5, 0.0, 0.0}, PoseMatrix<PlanarPose>::Zero());
  // Turned after each step: the last one moves nothing, that before it what comes after it.
  double aside = 0.0;
  for (int i = 0; i < 20; ++i) aside += 0.5 * i;
  const PoseMatrix<PlanarPose> covariance = chain.Covariance(0, 20);
  EXPECT_NEAR(covariance(2, 2), std::pow(20 * kTurn, 2), 1e-12);
  EXPECT_NEAR(covariance(1, 1), std::pow(aside * kTurn, 2), 1e-12);
  EXPECT_NEAR(covariance(0, 0), 0.0, 1e-12);
  EXPECT_NEAR(chain.Covariance(5, 15)(2, 2), std::pow(10 * kTurn, 2), 1e-12);
}

TEST(SeparateLoops, CountsThoseApartAtBothEnds) {
  EXPECT_EQ(SeparateLoops({}, 5), 0);
  // One run; then the same place again later: near at one end.
  std::vector<std::pair<int, int>> ends = {{10, 200}, {12, 203}, {14, 206}};
  EXPECT_EQ(SeparateLoops(ends, 10), 1);
  EXPECT_EQ(SeparateLoops(ends, 2), 2);
  EXPECT_EQ(SeparateLoops(ends, 1), 3);
  ends.emplace_back(11, 300);
  EXPECT_EQ(SeparateLoops(ends, 10), 1);
  ends.emplace_back(60, 250);
  EXPECT_EQ(SeparateLoops(ends, 10), 2);
  ends.emplace_back(100, 400);
  EXPECT_EQ(SeparateLoops(ends, 10), 3);
}

}  // namespace
}  // namespace bulletnav::agent
