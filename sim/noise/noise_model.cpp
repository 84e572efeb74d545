// SPDX-License-Identifier: MIT
#include "sim/noise/noise_model.h"

#include <map>
#include <string>

#include <Eigen/Cholesky>

#include "sim/base/check.h"
#include "sim/base/error.h"
#include "sim/noise/builtin_noise.h"

namespace bulletnav::sim {
namespace {

constexpr double kForwardStep = 0.25;
constexpr double kTurnStepDeg = 10.0;

enum class RotationUnit { kDeg, kRad };

struct ModeConfig {
  RotationUnit forward_do_unit = RotationUnit::kDeg;
  double sensor_dy_sign = 1.0;
  template <class V>
  void Visit(V& v) {
    v.Required("forward_do_unit", forward_do_unit);
    v.Required("sensor_dy_sign", sensor_dy_sign);
  }
};

struct MixturesConfig {
  using Components = std::vector<GaussianMixture::Component>;
  Components forward;
  Components turn_left;
  Components turn_right;
  template <class V>
  void Visit(V& v) {
    v.Required("forward", forward);
    v.Required("turn_left", turn_left);
    v.Required("turn_right", turn_right);
  }
  void Validate() const {
    for (const Components* c : {&forward, &turn_left, &turn_right}) GaussianMixture check(*c);
  }
};

struct NoiseConfig {
  std::string schema;
  double noise_level = 1.0;
  std::map<std::string, ModeConfig> modes;
  MixturesConfig actuation;
  MixturesConfig sensor;
  template <class V>
  void Visit(V& v) {
    v.Required("schema", schema);
    v("noise_level", noise_level);
    v.Required("modes", modes);
    v.Required("actuation", actuation);
    v.Required("sensor", sensor);
  }
  void Validate() const {
    if (schema != "bulletnav_noise/1") throw Error("schema must be bulletnav_noise/1");
  }
};

}  // namespace

template <>
struct EnumNames<RotationUnit> {
  static constexpr std::array kNames = {std::pair{"deg", RotationUnit::kDeg},
                                        std::pair{"rad", RotationUnit::kRad}};
};

PlanarPose NominalMotion(Action action) {
  switch (action) {
    case Action::kStop:
      return {};
    case Action::kMoveForward:
      return {kForwardStep, 0.0, 0.0};
    case Action::kTurnLeft:
      return {0.0, 0.0, DegToRad(kTurnStepDeg)};
    case Action::kTurnRight:
      return {0.0, 0.0, -DegToRad(kTurnStepDeg)};
  }
  BULLETNAV_CHECK(false);
}

GaussianMixture::GaussianMixture(const std::vector<Component>& components) {
  double total = 0.0;
  for (const Component& c : components) {
    if (c.weight < 0.0) throw Error("a mixture weight is negative");
    total += c.weight;
    Eigen::Matrix3d covariance;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        covariance(i, j) = c.covariance[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
      }
    }
    const Eigen::LLT<Eigen::Matrix3d> cholesky(covariance);
    if (cholesky.info() != Eigen::Success) throw Error("a covariance is not positive definite");
    weights_.push_back(c.weight);
    means_.emplace_back(c.mean[0], c.mean[1], c.mean[2]);
    factors_.emplace_back(cholesky.matrixL());
  }
  if (total <= 0.0) throw Error("a mixture needs a component of positive weight");
}

Eigen::Vector3d GaussianMixture::Sample(Rng& rng) const {
  const std::size_t i = rng.Weighted(weights_);
  const double a = rng.Normal();
  const double b = rng.Normal();
  const double c = rng.Normal();
  return means_[i] + factors_[i] * Eigen::Vector3d(a, b, c);
}

const GaussianMixture& NoiseModel::PerAction::of(Action action) const {
  switch (action) {
    case Action::kMoveForward:
      return forward;
    case Action::kTurnLeft:
      return turn_left;
    case Action::kTurnRight:
      return turn_right;
    case Action::kStop:
      break;
  }
  BULLETNAV_CHECK(false);
}

NoiseModel::NoiseModel(NoiseMode mode) : mode_(mode) {
  Parse(kBuiltinNoiseYaml, "built-in noise_models.yaml");
}

NoiseModel::NoiseModel(NoiseMode mode, const std::filesystem::path& file) : mode_(mode) {
  Parse(ReadYamlFile(file), file);
}

void NoiseModel::Parse(const std::string& text, const std::filesystem::path& name) {
  const auto config = LoadYamlText<NoiseConfig>(text, name);
  const auto mixtures = [](const MixturesConfig& c) {
    return PerAction{GaussianMixture(c.forward), GaussianMixture(c.turn_left),
                     GaussianMixture(c.turn_right)};
  };
  actuation_ = mixtures(config.actuation);
  sensor_ = mixtures(config.sensor);
  sensor_level_ = config.noise_level;
  if (mode_ == NoiseMode::kNone) return;
  const auto found = config.modes.find(std::string(NameOf(mode_)));
  if (found == config.modes.end()) {
    throw FileError(name, "modes", "has no mode '" + std::string(NameOf(mode_)) + "'");
  }
  const bool in_radians = found->second.forward_do_unit == RotationUnit::kRad;
  forward_rotation_scale_ = in_radians ? RadToDeg(1.0) : 1.0;
  sensor_dy_sign_ = found->second.sensor_dy_sign;
}

Eigen::Vector3d NoiseModel::Draw(const PerAction& mixtures, Action action, Rng& rng) const {
  Eigen::Vector3d draw = mixtures.of(action).Sample(rng);
  if (action == Action::kMoveForward) draw.z() *= forward_rotation_scale_;
  return draw;
}

PlanarPose NoiseModel::Actuation(Action action, Rng& rng) const {
  if (mode_ == NoiseMode::kNone || action == Action::kStop) return NominalMotion(action);
  const Eigen::Vector3d draw = Draw(actuation_, action, rng);
  return {draw.x(), -draw.y(), WrapAngle(-DegToRad(draw.z()))};
}

PlanarPose NoiseModel::Odometry(Action action, const PlanarPose& true_motion, Rng& rng) const {
  if (mode_ == NoiseMode::kNone || action == Action::kStop) return true_motion;
  const Eigen::Vector3d error = sensor_level_ * Draw(sensor_, action, rng);
  return {true_motion.x + error.x(), true_motion.y + sensor_dy_sign_ * error.y(),
          WrapAngle(true_motion.yaw + DegToRad(error.z()))};
}

}  // namespace bulletnav::sim
