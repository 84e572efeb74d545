// SPDX-License-Identifier: MIT
#include "tests/support/trials.h"

#include <array>

#include "benchmark/privileged/oracle_goal_estimator.h"
#include "benchmark/privileged/oracle_semantic_model.h"
#include "sim/base/error.h"

namespace bulletnav::tests {
namespace {

constexpr int kMostSteps = 500;

/// Where the body really stands when put at a pose; absent if it cannot stand there.
std::optional<sim::BodyPose> Stand(const sim::World& world, const sim::BodyPose& pose) {
  sim::CapsuleBody body(world.physics(), {});
  return body.TryReset(pose);
}

TrialResult Judge(const sim::SimulatedBody& body, const Trial& trial, bool stopped) {
  const sim::NavmeshQuery query(body.world().navmesh());
  const double left = query.GeodesicDistance(body.true_pose().position.cast<float>(),
                                             trial.goal.position.cast<float>());
  return {stopped, left, trial.geodesic, body.path_length(), body.steps(), body.collisions()};
}

sim::Observation LookFrom(const sim::World& world, const sim::SimulatorSpec& spec,
                          const sim::BodyPose& pose) {
  sim::Observation seen;
  if (spec.color) seen.color.resize(3 * spec.panorama.pixels());
  if (spec.depth) seen.depth.resize(spec.panorama.pixels());
  const Eigen::Vector3d eye = pose.position + Eigen::Vector3d(0, spec.body.camera_height, 0);
  const sim::CameraPose camera{eye.cast<float>(), static_cast<float>(pose.yaw)};
  world.render_scene().MakeRenderer(spec.panorama)->Render({&camera, 1}, seen.color, seen.depth);
  return seen;
}

}  // namespace

Trial DrawTrial(const std::shared_ptr<const sim::World>& world, double low, double high,
                sim::Rng* rng) {
  const sim::NavmeshQuery query(world->navmesh());
  while (true) {
    const auto start = Stand(
        *world, {query.RandomPoint(rng, 0).cast<double>(), rng->Uniform(-sim::kPi, sim::kPi)});
    const auto goal = Stand(
        *world, {query.RandomPoint(rng, 0).cast<double>(), rng->Uniform(-sim::kPi, sim::kPi)});
    if (!start || !goal) continue;
    const double geodesic =
        query.GeodesicDistance(start->position.cast<float>(), goal->position.cast<float>());
    if (geodesic >= low && geodesic < high) return {*start, *goal, geodesic, {1, rng->Next()}};
  }
}

TrialResult RunTrial(sim::Simulator* simulator, const Trial& trial, const agent::AgentMaker& maker,
                     const TrialHook& hook) {
  const sim::SimulatorSpec& spec = simulator->spec();
  // The world is the simulator's; only this function's end ends the loan.
  const std::shared_ptr<const sim::World> world(std::shared_ptr<void>(),
                                                &simulator->body().world());
  const sim::Observation goal = LookFrom(*world, spec, trial.goal);
  bench::GroundTruth truth{world, spec.body, trial.start, trial.goal,
                           agent::View(goal, 0).panorama};
  std::array contexts = {
      agent::AgentContext{{spec.panorama, spec.color, spec.depth, spec.body.camera_height}}};
  contexts[0].models.Set("semantic_model", std::make_shared<bench::OracleSemanticModel>(truth));
  const auto agent = maker(contexts);
  agent->Reset(0, agent::View(goal, 0).panorama, trial.key.episode);
  const sim::Observation* seen = &simulator->Reset(trial.start, trial.key);
  std::array actions = {sim::Action::kStop};
  for (int step = 0; step < kMostSteps; ++step) {
    truth.pose = simulator->body().true_pose();
    agent->Act(std::array{agent::LaneObservation{0, agent::View(*seen, step)}}, actions);
    if (hook) hook(*simulator, *agent);
    if (actions[0] == sim::Action::kStop) break;
    seen = &simulator->Step(actions[0]);
  }
  return Judge(simulator->body(), trial, actions[0] == sim::Action::kStop);
}

TrialResult RunTrial(sim::SimulatedBody* body, const sim::BodySpec& spec,
                     const std::shared_ptr<const sim::World>& world, const Trial& trial,
                     bench::PrivilegedAgent* agent) {
  body->Reset(trial.start, trial.key);
  bench::GroundTruth truth{world, spec, body->true_pose(), trial.goal};
  agent->Reset(truth);
  for (int step = 0; step < kMostSteps; ++step) {
    const sim::Action action = agent->Act(truth);
    if (action == sim::Action::kStop) return Judge(*body, trial, true);
    body->Step(action);
    truth.pose = body->true_pose();
  }
  return Judge(*body, trial, false);
}

}  // namespace bulletnav::tests
