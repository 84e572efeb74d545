// SPDX-License-Identifier: MIT
// Policies that are trained in a small building: what they are shown, and that a training goes on
// as if it had not been killed.
#include <filesystem>
#include <string>

#include <gmock/gmock.h>

#include "agent/models/model_registry.h"
#include "agent/models/safetensors.h"
#include "agent/policy/policy_model.h"
#include "benchmark/training/core/registry.h"
#include "benchmark/training/rl/lane_groups.h"
#include "benchmark/training/rl/navigation/navigation_lanes.h"
#include "benchmark/training/rl/navigation/navigation_plan.h"
#include "benchmark/training/rl/ppo.h"
#include "sim/base/error.h"
#include "tests/benchmark/training/supervised/watchers.h"
#include "tests/support/houses.h"
#include "tests/support/temporary_folder.h"

namespace bulletnav::bench {
namespace {

using tests::Killed;
using tests::Watcher;

using ::testing::Each;
using ::testing::HasSubstr;

class NavigationTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new tests::TemporaryFolder();
    tests::WriteShellHouses(folder_->path() / "houses", 2, 1);
  }
  static void TearDownTestSuite() {
    delete folder_;
    folder_ = nullptr;
  }
  static NavigationData Data() {
    NavigationData data;
    data.houses = DataHouses{(folder_->path() / "houses/index.json").string(), "train", 0};
    return data;
  }
  static NavigationSpec Spec(bool teaches) {
    NavigationSpec spec;
    spec.lanes = 4;
    spec.rows = 32;
    spec.teaches = teaches;
    spec.task.noise = sim::NoiseMode::kAnsReleased;
    spec.task.reward = RewardSpec{};
    spec.task.max_steps = 60;
    return spec;
  }
  static std::string Config(const std::string& task, const std::filesystem::path& out,
                            const std::string& more) {
    return "task: " + task + "\nout: " + out.string() +
           "\ndata: {houses: {index: " + (folder_->path() / "houses/index.json").string() +
           ", split: train}}\nvalidation: {houses: {index: " +
           (folder_->path() / "houses/index.json").string() +
           ", split: test}}\nvalidation_episodes: 2\n"
           "model: {width: 16, rows: 32, features: 32, memory: 32, step_limit: 40, precision: "
           "float32}\nsteps: 5\nvalidate_every: 2\n" +
           more;
  }
  static TrainJob Job(const std::string& config) {
    return MakeTraining(sim::ParseYaml(config, "policy.yaml"), "nts", {});
  }
  /// Trains once in one go and once with kills, and tells whether the weights are the same.
  static void ExpectResumes(const std::string& task, const std::string& more) {
    const auto out = [&](const char* name) {
      return folder_->path() / (task + name);
    };
    Watcher whole(0);
    RunTraining(Job(Config(task, out("_whole"), more)), &whole);
    for (const int kill_at : {3, 5}) {
      Watcher killed(kill_at);
      EXPECT_THROW(RunTraining(Job(Config(task, out("_parts"), more)), &killed), Killed);
    }
    Watcher rest(0);
    RunTraining(Job(Config(task, out("_parts"), more)), &rest);
    EXPECT_EQ(rest.resumed(), 4);
    const auto weights = [&](const char* name) {
      return agent::ReadTensorFile(out(name) / "weights.safetensors");
    };
    EXPECT_EQ(weights("_whole").tensors, weights("_parts").tensors);
    EXPECT_TRUE(agent::HoldsIntegers(weights("_whole")));
  }

  static tests::TemporaryFolder* folder_;
};

tests::TemporaryFolder* NavigationTest::folder_ = nullptr;

struct Shown {
  std::vector<float> numbers;
  std::vector<std::uint8_t> pictures;
  bool operator==(const Shown&) const = default;
};

Shown Look(PolicyTask* task) {
  const auto lanes = static_cast<std::size_t>(task->lanes());
  Shown shown;
  shown.numbers.resize(lanes * static_cast<std::size_t>(task->observation_size()));
  shown.pictures.resize(lanes * task->picture_bytes());
  task->Observe(shown.numbers, shown.pictures);
  return shown;
}

TEST_F(NavigationTest, EverySecondLaneSeesDepth) {
  NavigationScenes scenes(Data(), {}, 1);
  sim::WorkerPool pool(1);
  NavigationLanes lanes(Spec(false), &scenes, &pool);
  for (int lane = 0; lane < 4; ++lane) lanes.Begin(lane, 0);
  const Shown shown = Look(&lanes);
  std::vector<std::uint8_t> goal(lanes.picture_bytes());
  for (std::size_t lane = 0; lane < 4; ++lane) {
    lanes.ShowGoal(static_cast<int>(lane), goal);
    int seen = 0;
    int of_goal = 0;
    for (std::size_t i = 3; i < goal.size(); i += 4) {
      seen += shown.pictures[lane * goal.size() + i] > 0 ? 1 : 0;
      of_goal += goal[i] > 0 ? 1 : 0;
    }
    EXPECT_EQ(seen > 0, lane % 2 == 0);
    EXPECT_EQ(of_goal > 0, lane % 2 == 0);
  }
}

TEST_F(NavigationTest, TheTeacherReachesTheGoalAndItsScoreIsSpl) {
  NavigationScenes scenes(Data(), {}, 1);
  sim::WorkerPool pool(2);
  NavigationSpec spec = Spec(true);
  spec.task.max_steps = 500;
  NavigationLanes lanes(spec, &scenes, &pool);
  for (int lane = 0; lane < 4; ++lane) lanes.Begin(lane, 7);
  std::vector<int> actions(4);
  std::vector<LaneOutcome> outcomes(4);
  std::vector<LaneOutcome> ends(4);
  for (int step = 0; step < 200; ++step) {
    ASSERT_TRUE(lanes.Teach(actions));
    lanes.Step(actions, outcomes);
    for (int lane = 0; lane < 4; ++lane) {
      const auto i = static_cast<std::size_t>(lane);
      if (!outcomes[i].is_over()) continue;
      if (!ends[i].is_over()) ends[i] = outcomes[i];
      lanes.Begin(lane, 8);
    }
  }
  for (const LaneOutcome& end : ends) {
    EXPECT_TRUE(end.terminated);
    EXPECT_TRUE(end.success);
    EXPECT_GT(end.score, 0.7);
    EXPECT_GT(end.reward, 5.0);  // ten times SPL, and the last step's gain
  }
}

TEST_F(NavigationTest, LanesGoOnFromTheirStateInBothWorlds) {
  NavigationScenes scenes(Data(), {}, 1);
  sim::WorkerPool pool(1);
  NavigationLanes lanes(Spec(true), &scenes, &pool);
  for (int lane = 0; lane < 4; ++lane) lanes.Begin(lane, static_cast<std::uint64_t>(lane));
  std::vector<int> actions(4);
  std::vector<LaneOutcome> outcomes(4);
  for (int step = 0; step < 6; ++step) {
    lanes.Teach(actions);
    for (int& action : actions) action = action == 0 ? 1 : action;
    lanes.Step(actions, outcomes);
  }
  const std::vector<float> state = lanes.State();
  EXPECT_THAT(state, Each(testing::Lt(16777216.0f)));
  sim::WorkerPool threads(3);
  NavigationLanes again(Spec(true), &scenes, &threads);
  again.SetState(state);
  EXPECT_EQ(Look(&again), Look(&lanes));
  std::vector<int> lessons(4);
  again.Teach(lessons);
  lanes.Teach(actions);
  EXPECT_EQ(lessons, actions);
  EXPECT_EQ(again.State(), state);
}

TEST_F(NavigationTest, PpoBeginsWithTheRatioOneOnPictures) {
  NavigationScenes scenes(Data(), {}, 1);
  sim::WorkerPool pool(2);
  NavigationLanes lanes(Spec(false), &scenes, &pool);
  agent::PolicyConfig config;
  config.rows = 32;
  config.features = config.memory = 32;
  config.precision = agent::Precision::kFloat32;
  const auto make = [&] {
    return std::make_unique<PictureNet>(config, std::nullopt, 5);
  };
  const std::unique_ptr<PictureNet> net = make();
  LaneGroups groups(4, 2, make, net.get(), &pool);
  Actor actor(&lanes, net.get(), &pool, 2, 5);
  PlaySpec play;
  play.steps = 20;
  RunningMoments moments;
  const Rollout rollout = actor.Play(play, moments);
  class Still final : public Optimiser {
   public:
    void Step(double /*rate*/) override {}
    void Append(agent::TensorFile* /*content*/) const override {}
    void Set(const agent::TensorFile&, const std::filesystem::path&) override {}
  } still;
  PpoSpec spec;
  spec.lanes = 4;
  spec.group = 2;
  const PpoReport report = LearnFrom(rollout, spec, {&still, 0.0, 1}, &groups, net.get(), &moments);
  EXPECT_LT(report.first_ratio_error, 1e-3);
  EXPECT_EQ(report.first_clip_fraction, 0.0);
  EXPECT_NEAR(report.entropy, 1.16, 0.1);  // a fiftieth stops, the rest is even
}

TEST_F(NavigationTest, ImitationResumesBitForBit) {
  ExpectResumes("imitation",
                "lanes: 4\ngroup: 2\nrollout: 4\ndagger: {from: 1, to: 4, least: 0.2}\n");
}

TEST_F(NavigationTest, PpoResumesBitForBit) {
  ExpectResumes("ppo", "ppo: {lanes: 4, group: 2, rollout: 4}\n");
}

TEST_F(NavigationTest, BadConfigsAreNamed) {
  const auto complaint = [&](const std::string& task, const std::string& more) {
    try {
      Job(Config(task, folder_->path() / "bad", more));
    } catch (const sim::Error& error) {
      return std::string(error.what());
    }
    return std::string("none");
  };
  EXPECT_THAT(complaint("imitation", "lanes: 6\ngroup: 4\n"), HasSubstr("group must divide lanes"));
  EXPECT_THAT(complaint("imitation", "dagger: {from: 5, to: 1}\n"),
              HasSubstr("to must not be before from"));
  EXPECT_THAT(complaint("ppo", "policy_start: nowhere.safetensors\n"), HasSubstr("nowhere"));
  EXPECT_THAT(complaint("ppo", "ppo: {lanes: 8, group: 4, minibatches: 3}\n"),
              HasSubstr("minibatches must divide"));
}

}  // namespace
}  // namespace bulletnav::bench
