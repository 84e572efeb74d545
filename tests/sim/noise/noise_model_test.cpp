// SPDX-License-Identifier: MIT
#include "sim/noise/noise_model.h"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace bulletnav::sim {
namespace {

constexpr int kDraws = 1'000'000;

struct Moments {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
};

Moments MomentsOf(const std::function<Eigen::Vector3d()>& draw) {
  Moments m;
  for (int i = 0; i < kDraws; ++i) {
    const Eigen::Vector3d x = draw();
    m.mean += x;
    m.covariance += x * x.transpose();
  }
  m.mean /= kDraws;
  m.covariance = m.covariance / kDraws - m.mean * m.mean.transpose();
  return m;
}

/// Closed-form moments of a mixture.
Moments MomentsOf(const std::vector<GaussianMixture::Component>& components) {
  Moments m;
  for (const auto& c : components) m.mean += c.weight * Eigen::Vector3d(c.mean.data());
  for (const auto& c : components) {
    const Eigen::Vector3d d = Eigen::Vector3d(c.mean.data()) - m.mean;
    Eigen::Matrix3d covariance;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        covariance(i, j) = c.covariance[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
      }
    }
    m.covariance += c.weight * (covariance + d * d.transpose());
  }
  return m;
}

void ExpectNear(const Moments& sample, const Moments& truth) {
  for (int i = 0; i < 3; ++i) {
    const double sigma = std::sqrt(truth.covariance(i, i));
    EXPECT_NEAR(sample.mean[i], truth.mean[i], 5 * sigma / std::sqrt(kDraws)) << i;
    for (int j = 0; j < 3; ++j) {
      const double scale = sigma * std::sqrt(truth.covariance(j, j));
      EXPECT_NEAR(sample.covariance(i, j), truth.covariance(i, j), 0.01 * scale) << i << j;
    }
  }
}

TEST(GaussianMixture, MillionDrawsHaveTheMixturesMeanAndCovariance) {
  GaussianMixture::Component a;
  a.weight = 0.3;
  a.mean = {1.0, -2.0, 0.5};
  a.covariance = {{{0.5, 0.1, 0.0}, {0.1, 0.4, -0.2}, {0.0, -0.2, 0.3}}};
  GaussianMixture::Component b;
  b.weight = 0.7;
  b.mean = {-1.0, 0.0, 2.0};
  b.covariance = {{{0.1, 0.0, 0.05}, {0.0, 0.2, 0.0}, {0.05, 0.0, 0.9}}};
  const GaussianMixture mixture({a, b});
  Rng rng(1, "mixture");
  ExpectNear(MomentsOf([&] {
               return mixture.Sample(rng);
             }),
             MomentsOf({a, b}));
}

/// Means and standard deviations that the noise files state, in the robot's frame: x forward, y
/// left, yaw counter-clockwise in degrees.
struct Published {
  Action action;
  Eigen::Vector3d mean;
  Eigen::Vector3d std;
};

TEST(NoiseModel, ActuationHasThePublishedMoments) {
  const NoiseModel model(NoiseMode::kAnsReleased);
  const Published rows[] = {
      {Action::kMoveForward, {0.24563, -0.00204, -0.00921}, {0.00364, 0.00261, 0.00702}},
      {Action::kTurnLeft, {-0.00154, 0.01961, 360 - 348.73702}, {0.00201, 0.00157, 0.41745}},
      {Action::kTurnRight, {-0.00078, -0.01947, -11.08993}, {0.00229, 0.00153, 0.48384}}};
  Rng rng(2, "actuation");
  for (const Published& row : rows) {
    const Moments m = MomentsOf([&] {
      const PlanarPose p = model.Actuation(row.action, rng);
      return Eigen::Vector3d(p.x, p.y, RadToDeg(p.yaw));
    });
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(m.mean[i], row.mean[i], 0.01 * row.std[i]) << ActionName(row.action) << i;
      EXPECT_NEAR(std::sqrt(m.covariance(i, i)), row.std[i], 0.01 * row.std[i]);
    }
  }
}

TEST(NoiseModel, OdometryErrorsHaveThePublishedMomentsAndIgnoreTheMotion) {
  const NoiseModel model(NoiseMode::kAnsReleased);
  const Published rows[] = {
      {Action::kMoveForward, {0.00144, -0.00091, -0.00004}, {0.00273, 0.00231, 0.00224}},
      {Action::kTurnLeft, {0.00200, 0.01957, 0.19808}, {0.00144, 0.00156, 0.08361}},
      {Action::kTurnRight, {0.00195, -0.01939, 0.00777}, {0.00149, 0.00153, 0.08343}}};
  const PlanarPose truth{0.1, -0.2, 0.3};
  Rng rng(3, "odometry");
  for (const Published& row : rows) {
    const Moments m = MomentsOf([&] {
      const PlanarPose p = model.Odometry(row.action, truth, rng);
      return Eigen::Vector3d(p.x - truth.x, p.y - truth.y, RadToDeg(p.yaw - truth.yaw));
    });
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(m.mean[i], row.mean[i], 0.02 * row.std[i]) << ActionName(row.action) << i;
      EXPECT_NEAR(std::sqrt(m.covariance(i, i)), row.std[i], 0.01 * row.std[i]);
    }
  }
}

TEST(NoiseModel, ModesDifferOnlyWhereTheyShould) {
  const NoiseModel released(NoiseMode::kAnsReleased);
  const NoiseModel radians(NoiseMode::kAnsRadians);
  const NoiseModel physical(NoiseMode::kPhysical);
  for (const Action action : {Action::kMoveForward, Action::kTurnLeft, Action::kTurnRight}) {
    const double scale = action == Action::kMoveForward ? RadToDeg(1.0) : 1.0;
    Rng a(4, "modes");
    Rng b(4, "modes");
    Rng c(4, "modes");
    for (int i = 0; i < 100; ++i) {
      const PlanarPose x = released.Actuation(action, a);
      const PlanarPose y = radians.Actuation(action, b);
      EXPECT_EQ(x.x, y.x);
      EXPECT_NEAR(x.yaw * scale, y.yaw, 1e-9);
      const PlanarPose u = radians.Odometry(action, {}, b);
      physical.Actuation(action, c);
      const PlanarPose v = physical.Odometry(action, {}, c);
      EXPECT_EQ(u.x, v.x);
      EXPECT_EQ(u.y, -v.y);
      EXPECT_EQ(u.yaw, v.yaw);
      released.Odometry(action, {}, a);
    }
  }
}

TEST(NoiseModel, NoneIsExactAndStopIsSilent) {
  const NoiseModel none(NoiseMode::kNone);
  Rng rng(5, "none");
  EXPECT_EQ(none.Actuation(Action::kMoveForward, rng).x, 0.25);
  EXPECT_EQ(none.Actuation(Action::kTurnLeft, rng).yaw, DegToRad(10.0));
  EXPECT_EQ(none.Actuation(Action::kTurnRight, rng).yaw, -DegToRad(10.0));
  const PlanarPose truth{0.1, 0.2, 0.3};
  EXPECT_EQ(none.Odometry(Action::kMoveForward, truth, rng).y, 0.2);
  const NoiseModel noisy(NoiseMode::kAnsReleased);
  EXPECT_EQ(noisy.Actuation(Action::kStop, rng).x, 0.0);
  EXPECT_EQ(noisy.Odometry(Action::kStop, {}, rng).x, 0.0);
}

std::string ErrorOf(const std::string& text) {
  const tests::TemporaryFolder folder;
  try {
    const NoiseModel model(NoiseMode::kAnsReleased, folder.Write("noise.yaml", text));
  } catch (const FileError& e) {
    return e.what();
  }
  return "no error";
}

TEST(NoiseModel, BadFilesAreErrorsAtTheirPlace) {
  const std::string mixture =
      "[{weight: 1, mean: [0, 0, 0], covariance: [[1, 0, 0], [0, 1, 0], [0, 0, 1]]}]";
  const std::string family =
      "{forward: " + mixture + ", turn_left: " + mixture + ", turn_right: " + mixture + "}\n";
  const std::string head = "schema: bulletnav_noise/1\n";
  const std::string modes = "modes: {ans_released: {forward_do_unit: deg, sensor_dy_sign: 1}}\n";
  const std::string good = head + modes + "actuation: " + family + "sensor: " + family;
  EXPECT_EQ(ErrorOf(good), "no error");
  EXPECT_NE(ErrorOf(head + modes + "sensor: " + family).find("key 'actuation' is missing"),
            std::string::npos);
  EXPECT_NE(ErrorOf(head + "modes: {}\nactuation: " + family + "sensor: " + family)
                .find("has no mode 'ans_released'"),
            std::string::npos);
  std::string flat = good;
  flat.replace(flat.find("[1, 0, 0]"), 9, "[0, 0, 0]");
  EXPECT_NE(ErrorOf(flat).find("not positive definite"), std::string::npos);
  EXPECT_NE(ErrorOf("schema: other\n").find("missing"), std::string::npos);
}

}  // namespace
}  // namespace bulletnav::sim
