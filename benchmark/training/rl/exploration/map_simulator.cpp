// SPDX-License-Identifier: MIT
#include "benchmark/training/rl/exploration/map_simulator.h"

#include <algorithm>
#include <utility>

#include "agent/policy/exploration_view.h"
#include "sim/config/yaml_reader.h"

namespace bulletnav::bench {
namespace {

constexpr int kPlanEvery = 5;  // steps

agent::NavigatorSpec Navigator() {
  return {};
}

/// What each cell is worth; see MapSimulatorSpec::near_start.
std::vector<float> WeightsAround(const HeightColumns& columns, const Eigen::Vector3d& start,
                                 double near_start) {
  const double x = columns.AlongX(start.x());
  const double z = columns.AlongZ(start.z());
  const double near = near_start / HeightColumns::kCell;
  std::vector<float> weights;
  weights.reserve(columns.values().size());
  for (int row = 0; row < columns.depth(); ++row) {
    for (int i = 0; i < columns.width(); ++i) {
      const double off_x = i + 0.5 - x;
      const double off_z = row + 0.5 - z;
      const double squared = off_x * off_x + off_z * off_z;
      weights.push_back(static_cast<float>(std::min(1.0, near * near / squared)));
    }
  }
  return weights;
}

double SquareMetres(double cells) {
  return cells * HeightColumns::kCell * HeightColumns::kCell;
}

}  // namespace

void MapSimulatorSpec::Validate() const {
  if (goal_steps < 1) throw sim::KeyError("goal_steps", "goal_steps must be at least 1");
  if (episode_steps < goal_steps || episode_steps % goal_steps != 0) {
    throw sim::KeyError("episode_steps", "episode_steps must be a multiple of goal_steps");
  }
  if (!(odometry_kept >= 0.0 && odometry_kept <= 1.0)) {
    throw sim::KeyError("odometry_kept", "odometry_kept must be in [0, 1]");
  }
  if (near_start && !(*near_start > 0.0)) {
    throw sim::KeyError("near_start", "near_start must be positive");
  }
}

MapSimulator::MapSimulator(const MapSimulatorSpec& spec)
    : spec_(spec),
      noise_(spec.noise),
      made_view_(std::make_unique<Viewshed>(Navigator().map, double{body_spec_.camera_height})),
      view_(made_view_.get()),
      navigator_(Navigator(), std::move(made_view_), false),
      planner_(Navigator().map.cells()) {}

void MapSimulator::Begin(const ExplorationScene& scene, const sim::BodyPose& start,
                         std::uint64_t seed) {
  if (scene_ != &scene) {
    body_ = std::make_unique<sim::CapsuleBody>(scene.ground->physics, body_spec_);
  }
  scene_ = &scene;
  body_->Reset(start);
  seed_ = seed;
  steps_ = 0;
  collisions_ = 0;
  was_hindered_ = false;
  seen_.cells.assign(scene.columns->values().size(), 0);
  seen_.count = 0;
  seen_.weight = 0.0;
  if (spec_.near_start) {
    seen_.weights = WeightsAround(*scene.columns, start.position, *spec_.near_start);
  }
  navigator_.Reset();
  view_->Place(scene.columns.get(), body_->pose(), &seen_);
  navigator_.Observe({});
}

double MapSimulator::Walk(const agent::GoalSteps& goal) {
  const double before = worth();
  const agent::Point point =
      agent::GoalAt(navigator_.map(), navigator_.pose(), agent::SharesOf(goal));
  for (int i = 0; i < spec_.goal_steps; ++i) {
    Step(Choose(point, i % kPlanEvery == 0 || was_hindered_));
  }
  return worth() - before;
}

double MapSimulator::WalkToFrontiers() {
  const double before = worth();
  for (int i = 0; i < spec_.goal_steps; ++i) Step(ChooseByFrontier());
  return worth() - before;
}

sim::Action MapSimulator::ChooseByFrontier() {
  for (int tries = 0; tries < 2; ++tries) {
    if (const auto plan = navigator_.ToFrontier()) return navigator_.Steer(plan->point);
    navigator_.ForgetFeltWalls();
  }
  return sim::Action::kTurnLeft;  // all that can be got to is explored
}

sim::Action MapSimulator::Choose(const agent::Point& goal, bool plans) {
  if (plans) planner_.Plan(navigator_.map(), navigator_.here(), goal);
  const auto next = planner_.Next(navigator_.map(), navigator_.here());
  return next ? navigator_.Steer(*next) : sim::Action::kTurnLeft;
}

void MapSimulator::Step(sim::Action action) {
  const auto rng = [&](sim::Stream stream) {
    return sim::Rng(sim::RngKey{seed_, 0, 0, static_cast<std::uint32_t>(steps_), stream});
  };
  sim::Rng actuation = rng(sim::Stream::kActuation);
  sim::Rng odometry = rng(sim::Stream::kOdometry);
  navigator_.Took(action);
  const sim::BodyPose before = body_->pose();
  const sim::MoveResult move = body_->Move(noise_.Actuation(action, actuation));
  const sim::PlanarPose motion = sim::RelativePose(before, body_->pose());
  const sim::PlanarPose read = noise_.Odometry(action, motion, odometry);
  const auto mended = [&](double truth, double measured) {
    return truth + spec_.odometry_kept * (measured - truth);
  };
  ++steps_;
  collisions_ += move.collided ? 1 : 0;
  was_hindered_ = move.collided;
  agent::Observation seen;
  seen.odometry = {mended(motion.x, read.x), mended(motion.y, read.y),
                   motion.yaw + spec_.odometry_kept * sim::WrapAngle(read.yaw - motion.yaw)};
  view_->Place(scene_->columns.get(), body_->pose(), &seen_);
  navigator_.Observe(seen);
}

void MapSimulator::Show(std::span<std::uint8_t> view) const {
  agent::WriteExplorationView(navigator_.map(), navigator_.pose(), view);
}

int MapSimulator::heading() const {
  return agent::HeadingBin(navigator_.pose().yaw);
}

double MapSimulator::explored() const {
  return SquareMetres(static_cast<double>(seen_.count));
}

double MapSimulator::worth() const {
  return SquareMetres(seen_.weight);
}

}  // namespace bulletnav::bench
