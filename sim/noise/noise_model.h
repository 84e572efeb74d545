// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <filesystem>
#include <vector>

#include <Eigen/Core>

#include "sim/base/action.h"
#include "sim/config/yaml_reader.h"
#include "sim/math/pose.h"
#include "sim/math/rng.h"

namespace bulletnav::sim {

/// Which reading of the released noise files is used.
/// kNone: exactly 0.25 m and 10 deg, exact odometry.
/// kAnsReleased: as the released code applies them (rotation of a forward move read as degrees).
/// kAnsRadians: rotation of a forward move read as radians, which its size suggests.
/// kPhysical: as kAnsRadians, and the sideways sensor error turned to cancel the sideways slip of a
/// turn, as wheel odometry would see it.
enum class NoiseMode { kNone, kAnsReleased, kAnsRadians, kPhysical };

template <>
struct EnumNames<NoiseMode> {
  static constexpr std::array kNames = {std::pair{"none", NoiseMode::kNone},
                                        std::pair{"ans_released", NoiseMode::kAnsReleased},
                                        std::pair{"ans_radians", NoiseMode::kAnsRadians},
                                        std::pair{"physical", NoiseMode::kPhysical}};
};

/// Nominal motion of one action: 0.25 m forward, 10 deg, nothing for stop.
PlanarPose NominalMotion(Action action);

/// Mixture of Gaussians over (dx, dy, do).
class GaussianMixture {
 public:
  struct Component {
    double weight = 1.0;
    std::array<double, 3> mean{};
    std::array<std::array<double, 3>, 3> covariance{};
    template <class V>
    void Visit(V& v) {
      v.Required("weight", weight);
      v.Required("mean", mean);
      v.Required("covariance", covariance);
    }
  };

  GaussianMixture() = default;
  /// Throws Error if a weight is negative, none is positive, or a covariance is not positive
  /// definite.
  explicit GaussianMixture(const std::vector<Component>& components);

  /// Picks a component by weight, then mean + L z with L the lower Cholesky factor, z ~ N(0, I).
  Eigen::Vector3d Sample(Rng& rng) const;

 private:
  std::vector<double> weights_;
  std::vector<Eigen::Vector3d> means_;
  std::vector<Eigen::Matrix3d> factors_;
};

/// Actuation and odometry noise of Active Neural SLAM.
/// The mixtures' axes: dx forward (m), dy to the right (m), do clockwise (deg, modulo 360). An
/// actuation draw is the whole executed motion, not an addition to the command; a sensor draw is
/// added to the true motion of the step, in a frame whose y points left and whose do is
/// counter-clockwise. Everything this class takes and returns is in the robot's frame before the
/// action: x forward, y left, yaw counter-clockwise. Source: Neural-SLAM noise_models/,
/// env/habitat/utils/noisy_actions.py.
class NoiseModel {
 public:
  /// The model compiled into the program.
  explicit NoiseModel(NoiseMode mode);
  /// A model in the same YAML form from a file. Throws FileError.
  NoiseModel(NoiseMode mode, const std::filesystem::path& file);

  NoiseMode mode() const { return mode_; }

  /// The motion the body tries to make, before collisions.
  PlanarPose Actuation(Action action, Rng& rng) const;

  /// What the odometry sensor reads, given the true motion of the step after collisions.
  PlanarPose Odometry(Action action, const PlanarPose& true_motion, Rng& rng) const;

 private:
  struct PerAction {
    GaussianMixture forward;
    GaussianMixture turn_left;
    GaussianMixture turn_right;
    const GaussianMixture& of(Action action) const;
  };
  void Parse(const std::string& text, const std::filesystem::path& name);
  Eigen::Vector3d Draw(const PerAction& mixtures, Action action, Rng& rng) const;

  NoiseMode mode_;
  double forward_rotation_scale_ = 1.0;  // to degrees
  double sensor_dy_sign_ = 1.0;
  double sensor_level_ = 1.0;
  PerAction actuation_;
  PerAction sensor_;
};

}  // namespace bulletnav::sim
