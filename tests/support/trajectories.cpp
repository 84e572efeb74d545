// SPDX-License-Identifier: MIT
#include "tests/support/trajectories.h"

#include <array>

#include "benchmark/play/metrics.h"
#include "benchmark/privileged/oracle_goal_estimator.h"
#include "benchmark/privileged/oracle_semantic_model.h"
#include "benchmark/report/replay.h"

namespace bulletnav::tests {
namespace {

constexpr std::size_t kMostSteps = 500;

/// Keeps a trajectory up to date with a body.
class Recorder {
 public:
  Recorder(const std::shared_ptr<const sim::World>& world, const Trial& trial,
           const std::string& agent, sim::NoiseMode noise)
      : query_(world->navmesh()), watch_(query_, trial.start.position, trial.goal.position, {}) {
    trajectory_.result.key = {agent,
                              "rgbd",
                              noise == sim::NoiseMode::kNone ? "no_noise" : "noise",
                              trial.key.run_seed,
                              world->name(),
                              "0"};
    trajectory_.result.difficulty = bench::DifficultyAt(trial.geodesic);
    trajectory_.scene_file = world->name();
    trajectory_.key = trial.key;
    trajectory_.noise = noise;
    trajectory_.start = trial.start;
    trajectory_.goals = {trial.goal};
    const auto path =
        query_.FindPath(trial.start.position.cast<float>(), trial.goal.position.cast<float>());
    for (const Eigen::Vector3f& p : path->points) {
      trajectory_.shortest_path.push_back(p.cast<double>());
    }
  }

  /// Whether the episode is over.
  bool Record(sim::Action action, const sim::BodyPose& pose, const sim::Sensors& sensors) {
    odometry_ = sim::Compose(odometry_, sensors.odometry);
    trajectory_.steps.push_back({action, pose, odometry_, sensors.collided});
    stopped_ = action == sim::Action::kStop;
    if (!stopped_) watch_.Step(pose.position, sensors.collided);
    return stopped_ || trajectory_.steps.size() == kMostSteps;
  }

  bench::EpisodeTrajectory Finish(agent::Belief belief) {
    trajectory_.result.goals = {watch_.Finish(stopped_)};
    trajectory_.belief = std::move(belief);
    return std::move(trajectory_);
  }

 private:
  sim::NavmeshQuery query_;
  bench::GoalWatch watch_;
  bench::EpisodeTrajectory trajectory_;
  sim::PlanarPose odometry_;
  bool stopped_ = false;
};

}  // namespace

bench::EpisodeTrajectory RecordPrivileged(const std::shared_ptr<const sim::World>& world,
                                          const Trial& trial, const std::string& agent,
                                          sim::NoiseMode noise) {
  const auto privileged = bench::MakePrivilegedAgent(agent);
  sim::SimulatedBody body(world, {}, sim::NoiseModel(noise));
  body.Reset(trial.start, trial.key);
  bench::GroundTruth truth{world, {}, body.true_pose(), trial.goal};
  privileged->Reset(truth);
  Recorder recorder(world, trial, agent, noise);
  for (bool is_over = false; !is_over;) {
    truth.pose = body.true_pose();
    const sim::Action action = privileged->Act(truth);
    const sim::Sensors sensors = body.Step(action);
    is_over = recorder.Record(action, body.true_pose(), sensors);
  }
  return recorder.Finish({});
}

bench::EpisodeTrajectory RecordAgent(const std::shared_ptr<const sim::World>& world,
                                     const Trial& trial, const std::string& agent,
                                     sim::NoiseMode noise) {
  sim::SimulatorSpec spec;
  spec.noise = noise;
  sim::Simulator simulator(world, spec);
  bench::GroundTruth truth{world, spec.body, trial.start, trial.goal};
  std::array contexts = {agent::AgentContext{{spec.panorama, true, true, spec.body.camera_height}}};
  contexts[0].models.Set("semantic_model", std::make_shared<bench::OracleSemanticModel>(truth));
  const auto lanes = agent::ConfigureAgent(agent)(contexts);
  const sim::Image goal = bench::LookFrom(*world, spec.body, spec.panorama, trial.goal);
  truth.goal_panorama = {goal.pixels, {}};
  lanes->Reset(0, truth.goal_panorama, trial.key.episode);
  const sim::Observation* seen = &simulator.Reset(trial.start, trial.key);
  Recorder recorder(world, trial, agent, noise);
  std::array actions = {sim::Action::kStop};
  bool is_over = false;
  for (int step = 0; !is_over; ++step) {
    truth.pose = simulator.body().true_pose();
    lanes->Act(std::array{agent::LaneObservation{0, agent::View(*seen, step)}}, actions);
    seen = &simulator.Step(actions[0]);
    is_over = recorder.Record(actions[0], simulator.body().true_pose(), seen->sensors);
  }
  return recorder.Finish(lanes->belief(0));
}

bench::EpisodeTrajectory MadeUpTrajectory() {
  bench::EpisodeTrajectory trajectory;
  trajectory.result.key = {"made_up", "rgbd", "noise", 7, "house.glb", "12"};
  trajectory.result.difficulty = bench::Difficulty::kEasy;
  bench::GoalMetrics metrics;
  metrics["start_distance"] = 2.5;
  metrics["distance_to_goal"] = 0.25;
  metrics["success"] = true;
  metrics["spl"] = 0.625;
  metrics["path_length"] = 4.0;
  trajectory.scene_file = "folder/house.glb";
  trajectory.key = {7, (1ULL << 63) + 1};
  trajectory.noise = sim::NoiseMode::kPhysical;
  trajectory.body = sim::BodySpec::Locobot();
  trajectory.start = {{1.0, 0.0, -1.0}, 0.0};
  trajectory.goals = {{{3.0, 0.0, -3.25}, 1.5}};
  trajectory.shortest_path = {{1.0, 0.0, -1.0}, {3.0, 0.0, -3.25}};
  sim::BodyPose pose = trajectory.start;
  sim::PlanarPose odometry;
  const auto step = [&](sim::Action action, const sim::PlanarPose& motion, bool collided) {
    pose = sim::Apply(pose, motion);
    odometry = sim::Compose(odometry, {0.9 * motion.x, motion.y, motion.yaw});
    trajectory.steps.push_back({action, pose, odometry, collided});
    metrics["steps"] += action == sim::Action::kStop ? 0 : 1;
    metrics["collisions"] += collided ? 1 : 0;
  };
  for (int i = 0; i < 8; ++i) step(sim::Action::kMoveForward, {0.25, 0, 0}, i == 7);
  for (int i = 0; i < 9; ++i) step(sim::Action::kTurnRight, {0, 0, -sim::kPi / 18}, false);
  for (int i = 0; i < 8; ++i) step(sim::Action::kMoveForward, {0.25, 0, 0}, false);
  step(sim::Action::kStop, {}, false);
  trajectory.result.goals = {metrics};
  using Kind = agent::MapPicture::Kind;
  agent::MapPicture map{3, 0.5, -0.5, -0.5, std::vector<Kind>(9, Kind::kUnknown)};
  map.kinds[3] = map.kinds[4] = Kind::kFree;
  map.kinds[5] = Kind::kObstacle;
  map.kinds[8] = Kind::kFeltWall;
  trajectory.belief = {
      odometry, sim::PlanarPose{2.0, 1.0, 0.0}, map,
      agent::GraphPicture{
          {{0, 0, false}, {2, 0, false}, {2, 1, true, 0.75}}, {{0, 1}, {1, 2}}, {0, 1, 2}}};
  return trajectory;
}

}  // namespace bulletnav::tests
