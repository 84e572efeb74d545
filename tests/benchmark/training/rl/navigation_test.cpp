// SPDX-License-Identifier: MIT
// Policies that are trained in a small building: what they are shown, and that a training goes on
// as if it had not been killed.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include "agent/models/model_registry.h"
#include "agent/models/safetensors.h"
#include "agent/policy/policy_model.h"
#include "benchmark/training/core/registry.h"
#include "benchmark/training/rl/lane_groups.h"
#include "benchmark/training/rl/navigation/imitation_loss.h"
#include "benchmark/training/rl/navigation/navigation_lanes.h"
#include "benchmark/training/rl/navigation/navigation_plan.h"
#include "benchmark/training/rl/navigation/picture_net.h"
#include "benchmark/training/rl/navigation/policy_evaluation.h"
#include "benchmark/training/rl/navigation/policy_stitching.h"
#include "benchmark/training/rl/navigation/policy_validation.h"
#include "benchmark/training/rl/ppo.h"
#include "sim/base/error.h"
#include "sim/base/files.h"
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
    if (teaches) spec.teacher_stops = 0.5;
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
           "float32" +
           (more.starts_with("map") ? ", map: true}\nsetting: rgbd" : "}") +
           "\nsteps: 5\nvalidate_every: 2\n" + (more.starts_with("map") ? more.substr(4) : more);
  }
  static TrainJob Job(const std::string& config) {
    return MakeTraining(sim::ParseYaml(config, "policy.yaml"), "nts", {});
  }
  /// Trains until a step, after which that ends as a kill would end it.
  static void Kill(const std::string& config, int step) {
    Watcher killed(step);
    EXPECT_THROW(RunTraining(Job(config), &killed), Killed);
  }
  /// Likewise in a process of its own, which is gone at once.
  static void KillProcess(const std::string& config, int step) {
    class Killer final : public Watcher {
     public:
      explicit Killer(int kill_at) : kill_at_(kill_at) {}
      void Stepped(int at, double /*loss*/) override {
        if (at == kill_at_) ::raise(SIGKILL);
      }

     private:
      int kill_at_;
    };
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      Killer killer(step);
      RunTraining(Job(config), &killer);
      std::_Exit(0);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL);
  }
  /// Trains once in one go and once with kills, and tells whether the weights are the same.
  static void ExpectResumes(const std::string& task, const std::string& more,
                            const std::string& kind = "",
                            void (*kill)(const std::string&, int) = Kill) {
    const auto out = [&](const char* name) {
      return folder_->path() / (task + kind + name);
    };
    for (const int kill_at : {3, 5}) kill(Config(task, out("_parts"), more), kill_at);
    Watcher rest(0);
    RunTraining(Job(Config(task, out("_parts"), more)), &rest);
    EXPECT_EQ(rest.resumed(), 4);
    Watcher whole(0);  // after the kills: processes are forked before torch has threads
    RunTraining(Job(Config(task, out("_whole"), more)), &whole);
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

/// What the teacher does, in lanes where it knows a way.
std::vector<int> Taught(PolicyTask* task) {
  std::vector<Lesson> lessons(static_cast<std::size_t>(task->lanes()));
  EXPECT_TRUE(task->Teach(lessons));
  std::vector<int> actions;
  for (const Lesson& lesson : lessons) {
    EXPECT_TRUE(lesson.counts);
    actions.push_back(lesson.action);
  }
  return actions;
}

TEST_F(NavigationTest, LooksChangeWhatIsDrawnAndNothingElse) {
  sim::WorkerPool pool(1);
  const auto begin = [&](const NavigationData& data) {
    NavigationScenes scenes(data, {}, 1);
    NavigationLanes lanes(Spec(false), &scenes, &pool);
    for (int lane = 0; lane < 4; ++lane) lanes.Begin(lane, 0);
    const std::vector<int> turn(4, static_cast<int>(sim::Action::kTurnLeft));
    std::vector<LaneOutcome> outcomes(4);
    lanes.Step(turn, outcomes);
    return Look(&lanes);
  };
  NavigationData data = Data();
  const Shown plain = begin(data);
  data.looks = LooksSpec{};
  data.looks->share = 0.0;
  EXPECT_EQ(begin(data), plain);
  data.looks->share = 1.0;
  const Shown other = begin(data);
  EXPECT_EQ(other.numbers, plain.numbers);
  EXPECT_NE(other.pictures, plain.pictures);
  EXPECT_EQ(begin(data), other);
  data.plain_share = 1.0;
  EXPECT_EQ(begin(data), plain);
}

TEST_F(NavigationTest, AShareOfTheEpisodesIsPlayedInHousesAsTheyAre) {
  NavigationData data = Data();
  data.looks = LooksSpec{};
  data.looks->share = 1.0;
  data.plain_share = 0.25;
  NavigationScenes scenes(data, {}, 1);
  EXPECT_EQ(scenes.plain_count(), scenes.count());
  std::map<std::filesystem::path, std::map<const sim::World*, int>> drawn;
  for (std::uint64_t i = 0; i < 200; ++i) {
    const NavigationScenes::Drawn one = scenes.Draw(static_cast<int>(i), i);
    ++drawn[one.episode.scene_file][one.world.get()];
  }
  EXPECT_EQ(drawn.size(), scenes.count());
  int rarer = 0;
  for (const auto& [file, worlds] : drawn) {
    ASSERT_EQ(worlds.size(), 2U);
    rarer += std::min(worlds.begin()->second, worlds.rbegin()->second);
  }
  EXPECT_GT(rarer, 25);
  EXPECT_LT(rarer, 75);
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

TEST_F(NavigationTest, LanesAreTheSameWhoeverSharesThem) {
  NavigationScenes scenes(Data(), {}, 1);
  sim::WorkerPool pool(1);
  NavigationLanes whole(Spec(false), &scenes, &pool);
  NavigationSpec half = Spec(false);
  half.lanes = 1;
  half.first_lane = 3;
  NavigationLanes last(half, &scenes, &pool);
  for (int lane = 0; lane < 4; ++lane) whole.Begin(lane, 2);
  last.Begin(0, 2);
  const Shown all = Look(&whole);
  const Shown own = Look(&last);
  const auto bytes = static_cast<std::ptrdiff_t>(last.picture_bytes());
  EXPECT_TRUE(
      std::equal(own.pictures.begin(), own.pictures.end(), all.pictures.begin() + 3 * bytes));
}

TEST_F(NavigationTest, PicturesDrawnDirectlyAreAlmostTheAveragedOnesUntilTheyAreThose) {
  NavigationScenes scenes(Data(), {}, 1);
  sim::WorkerPool pool(2);
  NavigationSpec spec = Spec(false);
  spec.setting = LaneSetting::kRgbd;
  NavigationLanes averaged(spec, &scenes, &pool);
  spec.draw = DrawMode::kDirect;
  NavigationLanes direct(spec, &scenes, &pool);
  for (const double done : {0.0, 0.95}) {
    averaged.StartRollout(done);
    direct.StartRollout(done);
    for (int lane = 0; lane < 4; ++lane) {
      averaged.Begin(lane, 1);
      direct.Begin(lane, 1);
    }
    const Shown a = Look(&averaged);
    const Shown b = Look(&direct);
    EXPECT_EQ(a.numbers, b.numbers);
    ASSERT_EQ(a.pictures.size(), b.pictures.size());
    double off = 0.0;
    for (std::size_t i = 0; i < a.pictures.size(); ++i) {
      off += std::abs(a.pictures[i] - b.pictures[i]) / static_cast<double>(a.pictures.size());
    }
    if (done == 0.0) {
      EXPECT_GT(off, 0.01);
      EXPECT_LT(off, 8.0);
    } else {
      EXPECT_EQ(off, 0.0);
    }
  }
}

TEST_F(NavigationTest, LanesWithMapsGoOnFromTheirStateAcrossWaysOfDrawing) {
  NavigationScenes scenes(Data(), {}, 1);
  sim::WorkerPool pool(2);
  NavigationSpec spec = Spec(true);
  spec.setting = LaneSetting::kRgbd;
  spec.map = true;
  spec.draw = DrawMode::kDirect;
  NavigationLanes lanes(spec, &scenes, &pool);
  for (int lane = 0; lane < 4; ++lane) lanes.Begin(lane, 1);
  std::vector<int> actions(4);
  std::vector<LaneOutcome> outcomes(4);
  const Shown start = Look(&lanes);
  for (int step = 0; step < 9; ++step) {
    if (step == 5) {
      lanes.StartRollout(0.9);
      lanes.Begin(2, 2);
    }
    actions = Taught(&lanes);
    Look(&lanes);
    for (int& action : actions) action = action == 0 ? 2 : action;
    lanes.Step(actions, outcomes);
  }
  NavigationLanes again(spec, &scenes, &pool);
  again.SetState(lanes.State());
  again.StartRollout(0.9);
  EXPECT_EQ(again.State(), lanes.State());
  const Shown shown = Look(&lanes);
  EXPECT_EQ(Look(&again), shown);
  EXPECT_EQ(Look(&again), shown);  // however often the same is looked at
  const std::size_t bytes = lanes.picture_bytes();
  EXPECT_FALSE(std::equal(shown.pictures.end() - agent::kPolicyMapBytes, shown.pictures.end(),
                          start.pictures.end() - agent::kPolicyMapBytes));
  std::vector<std::uint8_t> goal(bytes, 1);
  lanes.ShowGoal(0, goal);
  EXPECT_EQ(std::count(goal.end() - agent::kPolicyMapBytes, goal.end(), 0),
            static_cast<std::ptrdiff_t>(agent::kPolicyMapBytes));
}

/// How an episode ended, and after how many steps; 0: not within 200.
struct Ending {
  LaneOutcome outcome;
  int steps = 0;
};

/// Each lane's first episode, in which the teacher acts.
std::array<Ending, 4> TaughtEndings(NavigationSpec spec, NavigationScenes* scenes) {
  sim::WorkerPool pool(2);
  spec.task.max_steps = 500;
  NavigationLanes lanes(spec, scenes, &pool);
  for (int lane = 0; lane < 4; ++lane) lanes.Begin(lane, 7);
  std::vector<LaneOutcome> outcomes(4);
  std::array<Ending, 4> endings;
  for (int step = 1; step <= 200; ++step) {
    lanes.Step(Taught(&lanes), outcomes);
    for (int lane = 0; lane < 4; ++lane) {
      const auto i = static_cast<std::size_t>(lane);
      if (!outcomes[i].is_over()) continue;
      if (endings.at(i).steps == 0) endings.at(i) = {outcomes[i], step};
      lanes.Begin(lane, 8);
    }
  }
  return endings;
}

TEST_F(NavigationTest, TheTeacherReachesTheGoalAndItsScoreIsSpl) {
  NavigationScenes scenes(Data(), {}, 1);
  for (const Ending& ending : TaughtEndings(Spec(true), &scenes)) {
    const LaneOutcome& end = ending.outcome;
    EXPECT_TRUE(end.terminated);
    EXPECT_TRUE(end.success);
    EXPECT_GT(end.score, 0.7);
    EXPECT_GT(end.reward, 5.0);  // ten times SPL, and the last step's gain
  }
}

TEST_F(NavigationTest, TheTeacherStopsWhereItIsTold) {
  NavigationScenes scenes(Data(), {}, 1);
  const auto endings_at = [&](double stops) {
    NavigationSpec spec = Spec(true);
    spec.teacher_stops = stops;
    return TaughtEndings(spec, &scenes);
  };
  const std::array<Ending, 4> near = endings_at(0.3);
  const std::array<Ending, 4> far = endings_at(0.9);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_TRUE(near.at(i).outcome.success);
    EXPECT_TRUE(far.at(i).outcome.success);
    EXPECT_GT(far.at(i).steps, 0);
    EXPECT_LT(far.at(i).steps, near.at(i).steps);  // the same way, of which it leaves off more
  }
}

TEST_F(NavigationTest, WhoRunsOutOfStepsHasTerminatedSinceItKnewHowManyWereLeft) {
  NavigationScenes scenes(Data(), {}, 1);
  sim::WorkerPool pool(1);
  NavigationSpec spec = Spec(false);
  spec.task.max_steps = 5;
  NavigationLanes lanes(spec, &scenes, &pool);
  for (int lane = 0; lane < 4; ++lane) lanes.Begin(lane, 0);
  const std::vector<int> turn(4, static_cast<int>(sim::Action::kTurnLeft));
  std::vector<LaneOutcome> outcomes(4);
  for (int step = 1; step <= 5; ++step) {
    EXPECT_FLOAT_EQ(Look(&lanes).numbers[7], static_cast<float>(step - 1) / 5.0F);
    lanes.Step(turn, outcomes);
    for (const LaneOutcome& outcome : outcomes) {
      EXPECT_EQ(outcome.terminated, step == 5);
      EXPECT_FALSE(outcome.truncated);
      EXPECT_FALSE(outcome.success);
      EXPECT_LT(outcome.reward, 0.5);  // no share of what a success is worth
    }
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
    actions = Taught(&lanes);
    for (int& action : actions) action = action == 0 ? 1 : action;
    lanes.Step(actions, outcomes);
  }
  const std::vector<float> state = lanes.State();
  EXPECT_THAT(state, Each(testing::Lt(16777216.0f)));
  sim::WorkerPool threads(3);
  NavigationLanes again(Spec(true), &scenes, &threads);
  again.SetState(state);
  EXPECT_EQ(Look(&again), Look(&lanes));
  EXPECT_EQ(Taught(&again), Taught(&lanes));
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

/// Notes what it is shown, and stops after three steps.
class Noting final : public agent::PolicyModel {
 public:
  struct Notes {
    std::vector<float> goals;  // sums of what is seen of them
    float seen = 0.0F;
    int squares = 0;  // panoramas of squares of four by four equal pixels
  };
  explicit Noting(Notes* notes) : notes_(notes) {}
  int step_limit() const override { return 40; }
  std::vector<float> NoMemory() const override { return {0.0F}; }
  std::vector<float> CodeOf(const agent::Panorama& goal) override {
    notes_->goals.push_back(SumOf(goal));
    return {0.0F};
  }
  std::array<float, 4> Act(const agent::PolicyQuestion& question,
                           std::vector<float>* memory) override {
    notes_->seen += SumOf(question.panorama);
    notes_->squares += IsOfSquares(question.panorama) ? 1 : 0;
    memory->front() += 1.0F;
    if (memory->front() > 3.0F) return {1.0F, 0.0F, 0.0F, 0.0F};
    return {0.0F, 0.0F, 1.0F, 0.0F};
  }

 private:
  static bool IsOfSquares(const agent::Panorama& panorama) {
    for (std::size_t row = 0; row < 128; ++row) {
      for (std::size_t col = 0; col < 512; ++col) {
        const std::size_t corner = row / 4 * 4 * 512 + col / 4 * 4;
        if (panorama.depth[row * 512 + col] != panorama.depth[corner]) return false;
        if (panorama.color[3 * (row * 512 + col)] != panorama.color[3 * corner]) return false;
      }
    }
    return true;
  }
  static float SumOf(const agent::Panorama& panorama) {
    float sum = 0.0F;
    for (const std::uint8_t value : panorama.color) sum += static_cast<float>(value);
    for (const float value : panorama.depth) sum += value;
    return sum;
  }
  Notes* notes_;
};

TEST_F(NavigationTest, PoliciesAreTriedWithOtherGoalsAndWithOtherImages) {
  NavigationScenes scenes(Data(), {}, 1);
  const PolicyValidation validation(&scenes, Spec(false).task, 3);
  sim::WorkerPool pool(1);
  const auto notes_of = [&](bool shuffles, bool blanks, int direct_rows) {
    Noting::Notes notes;
    PolicyValidation::Way way;
    way.with_depth = true;
    way.pool = &pool;
    way.shuffle_goals = shuffles;
    way.blank_images = blanks;
    way.direct_rows = direct_rows;
    Measures measures;
    validation.Measure(
        [&] {
          return std::make_shared<Noting>(&notes);
        },
        way, &measures);
    EXPECT_EQ(measures.at("steps"), 3.0);  // a stop is none
    EXPECT_EQ(measures.at("stopped"), 1.0);
    return notes;
  };
  const Noting::Notes plain = notes_of(false, false, 0);
  const Noting::Notes shuffled = notes_of(true, false, 0);
  const Noting::Notes blank = notes_of(false, true, 0);
  const Noting::Notes direct = notes_of(false, false, 32);
  ASSERT_EQ(plain.goals.size(), 3U);
  EXPECT_GT(plain.seen, 0.0F);
  EXPECT_EQ(shuffled.seen, plain.seen);
  EXPECT_NE(plain.goals[0], plain.goals[1]);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(shuffled.goals[i], plain.goals[(i + 1) % 3]);
  EXPECT_THAT(blank.goals, Each(0.0F));
  EXPECT_EQ(blank.seen, 0.0F);
  EXPECT_EQ(plain.squares, 0);
  EXPECT_EQ(direct.squares, 12);  // of three episodes, with the steps that stop
  EXPECT_NEAR(direct.seen / plain.seen, 1.0, 0.02);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(direct.goals[i] / plain.goals[i], 1.0, 0.02);
}

TEST_F(NavigationTest, ScalesOfIntegersAreOfAllThatThePolicyIsShown) {
  NavigationScenes scenes(Data(), {}, 1);
  const PolicyValidation validation(&scenes, Spec(false).task, 2);
  agent::PolicyConfig config;
  config.rows = 32;
  const auto depths = [&](const torch::Tensor& pictures) {
    return pictures.view({pictures.size(0), -1, 4}).select(2, 3).to(torch::kFloat32).mean(1);
  };
  const auto both = validation.Calibration(config, LaneSetting::kBoth);
  const std::int64_t half = both.pictures.size(0) / 2;
  for (const torch::Tensor& pictures : {both.pictures, both.goal_pictures}) {
    EXPECT_EQ(depths(pictures).narrow(0, 0, half).abs().max().item<float>(), 0.0F);
    EXPECT_GT(depths(pictures).narrow(0, half, half).min().item<float>(), 0.0F);
  }
  const auto with_depth = validation.Calibration(config, LaneSetting::kRgbd);
  EXPECT_TRUE(at::equal(both.pictures.narrow(0, half, half), with_depth.pictures));
  EXPECT_EQ(both.numbers.size(0), 2 * half);
}

/// An encoder that was trained on colour alone gives other codes if it is shown depth.
TEST_F(NavigationTest, StitchShowsEachEncoderWhatItWasTrainedOn) {
  const torch::NoGradGuard no_grad;
  agent::PolicyConfig config;
  config.rows = config.features = config.memory = 32;
  agent::PolicyNet encoder(config, 4);
  torch::Tensor stem = encoder.named_parameters()["encoder.trunk.stem.weight"];
  stem.select(1, agent::kInputChannels - 1).mul_(4.0);
  const torch::Tensor some =
      torch::randint(0, 255, {8, encoder.picture_bytes()}, torch::TensorOptions(torch::kUInt8));
  const agent::QuantisedNet integers =
      agent::Quantise(&encoder, {some, some, torch::zeros({8, agent::kPolicyNumbers})});
  config.own_encoder = false;
  agent::PolicyNet policy(config, 5);
  policy.SeeWith(std::make_shared<agent::IntegerSight>(integers, config.rows));
  const auto file = [&](const std::string& setting) {
    return (folder_->path() / ("sees_" + setting + ".safetensors")).string();
  };
  for (const std::string setting : {"rgb", "rgbd"}) {
    agent::SavePolicy(policy, {{"training", "setting: " + setting}}, agent::StoredType::kFloat32,
                      file(setting));
  }
  const std::string out = (folder_->path() / "stitched.safetensors").string();
  const auto explained = [&](const std::string& of_policy, const std::string& of_other) {
    StitchConfig stitch;
    stitch.weights = file(of_policy);
    stitch.encoder = file(of_other);
    stitch.data = Data();
    stitch.pictures = agent::kCodeSize;
    return Stitch(stitch, out, {});
  };
  EXPECT_GT(explained("rgbd", "rgbd"), 0.99);
  EXPECT_GT(explained("rgb", "rgb"), 0.99);
  const double between = explained("rgbd", "rgb");
  EXPECT_GT(between, 0.0);
  EXPECT_LT(between, 0.99);
  StitchConfig again;
  again.weights = out;
  again.encoder = file("rgb");
  EXPECT_THAT(
      [&] {
        Stitch(again, out, {});
      },
      testing::ThrowsMessage<sim::FileError>(HasSubstr("was stitched already")));
}

TEST_F(NavigationTest, RolloutsThatDoNotFitAreRefusedBeforeScenesAreLoaded) {
  for (const auto& [task, more] :
       {std::pair{"ppo", "ppo: {lanes: 4096, group: 4, rollout: 65536}\n"},
        {"imitation", "lanes: 4096\ngroup: 4\nrollout: 65536\n"}}) {
    TrainContext context;
    context.start = [](const std::string& what, int) -> std::function<void()> {
      ADD_FAILURE() << what;
      return [] {};
    };
    try {
      MakeTraining(sim::ParseYaml(Config(task, folder_->path() / "large", more), "policy.yaml"),
                   "nts", context);
      FAIL();
    } catch (const sim::Error& e) {
      EXPECT_THAT(e.what(), HasSubstr("a rollout of 65536 steps in 4096 lanes takes"));
    }
  }
}

TEST_F(NavigationTest, EvaluatesWhatAFileOfWeightsHolds) {
  const std::filesystem::path file = folder_->path() / "untrained.safetensors";
  agent::PolicyConfig policy;
  policy.rows = 32;
  policy.features = policy.memory = 32;
  policy.step_limit = 20;
  agent::SavePolicy(agent::PolicyNet(policy, 1), {}, agent::StoredType::kFloat32, file);
  const auto config = sim::LoadYamlText<PolicyEvaluationConfig>(
      "weights: here\ndata: {houses: {index: " + (folder_->path() / "houses/index.json").string() +
          ", split: train}}\nepisodes: 2\nsetting: both\n",
      "evaluate.yaml");
  const auto rows = EvaluatePolicy(config, file, {true, true, true}, 1, {});
  ASSERT_EQ(rows.size(), 8U);
  EXPECT_EQ(rows[1].trial, "shuffled goals");
  EXPECT_EQ(rows[3].trial, "direct images");
  EXPECT_EQ(rows[5].setting, "rgbd");
  for (const PolicyEvaluationRow& row : rows) EXPECT_LE(row.measures.at("steps"), 20.0);
  EXPECT_THAT(ToText(rows), HasSubstr("blank images"));
  EXPECT_THAT(ToJson(rows), HasSubstr("\"trial\": \"as it is\""));
  EXPECT_THROW(EvaluatePolicy(config, folder_->path() / "houses/index.json", {}, 1, {}),
               sim::Error);
}

/// Shipped policies are tried as they act in runs.
TEST_F(NavigationTest, PoliciesOfBothTrainingsActAsTheirAgentsDo) {
  const std::filesystem::path weights = BULLETNAV_WEIGHTS;
  EXPECT_EQ(UsualAgent(weights / "resnet_gru_il_rgbd.safetensors").stop_from,
            agent::kAfterImitation.stop_from);
  for (const char* name : {"target_driven_rl_rgb", "metric_map_rl_rgbd"}) {
    EXPECT_EQ(UsualAgent(weights / (std::string(name) + ".safetensors")).stop_from,
              agent::kAfterReward.stop_from)
        << name;
  }
}

TEST_F(NavigationTest, FixedEpisodesComeAgainAndAgain) {
  NavigationData data = Data();
  data.episodes = 3;
  NavigationScenes scenes(data, {}, 1);
  std::set<std::string> known;
  for (std::uint64_t i = 0; i < 3; ++i) known.insert(scenes.DrawInTurn(i).episode.episode.id);
  std::set<std::string> drawn;
  for (std::uint64_t i = 0; i < 40; ++i) {
    drawn.insert(scenes.Draw(static_cast<int>(i % 4), i).episode.episode.id);
  }
  EXPECT_EQ(drawn, known);
}

TEST_F(NavigationTest, ShippedConfigsOfTrialsLoad) {
  const std::filesystem::path folder = BULLETNAV_CONFIGS;
  EXPECT_NO_THROW(sim::LoadYaml<PolicyEvaluationConfig>(folder / "evaluate_policy.yaml"));
  EXPECT_NO_THROW(sim::LoadYaml<StitchConfig>(folder / "stitch.yaml"));
  EXPECT_NO_THROW(sim::LoadYaml<StitchConfig>(folder / "stitch_wide.yaml"));
}

TEST(ImitationLoss, IsTheWeightedMeanOverTheLessonsAlone) {
  const torch::Tensor said =
      torch::rand({3, 2, 4}, at::detail::createCPUGenerator(5)).log_softmax(-1);
  const torch::Tensor lessons =
      torch::tensor({0, 1, 2, kNoLesson, 1, 3}, torch::kInt64).view({3, 2});
  const ImitationLoss found = ImitationLossOf(said, lessons, {5.0, 3.0});
  const auto flat = said.reshape({6, 4});
  double sum = 0.0;
  double weights = 0.0;
  double agreed = 0.0;
  for (const int i : {0, 1, 2, 4, 5}) {
    const auto lesson = lessons.view({6})[i].item<std::int64_t>();
    const bool stops = lesson == static_cast<int>(sim::Action::kStop);
    const bool goes = lesson == static_cast<int>(sim::Action::kMoveForward);
    const double weight = stops ? 5.0 : goes ? 3.0 : 1.0;
    sum -= weight * flat[i][lesson].item<double>();
    weights += weight;
    agreed += flat[i].argmax().item<std::int64_t>() == lesson ? 0.2 : 0.0;
  }
  EXPECT_NEAR(found.loss.item<double>(), sum / weights, 1e-6);
  EXPECT_NEAR(found.agreement, agreed, 1e-6);
}

TEST(ImitationLoss, LearnsNothingWhereTheTeacherKnowsNoWay) {
  torch::Tensor scores = torch::zeros({2, 3, 4}).requires_grad_(true);
  torch::Tensor lessons = torch::full({2, 3}, kNoLesson, torch::kInt64);
  const auto gradient_of = [&] {
    const ImitationLoss found = ImitationLossOf(scores.log_softmax(-1), lessons, {5.0, 1.0});
    found.loss.backward();
    const torch::Tensor gradient = scores.grad().clone();
    scores.mutable_grad().reset();
    EXPECT_TRUE(std::isfinite(found.loss.item<double>()));
    return gradient;
  };
  EXPECT_EQ(gradient_of().abs().sum().item<double>(), 0.0);
  lessons[1][2] = 0;
  const torch::Tensor of_one = gradient_of().abs().sum(-1);
  EXPECT_GT(of_one[1][2].item<double>(), 0.0);
  EXPECT_EQ(of_one.sum().item<double>(), of_one[1][2].item<double>());
}

TEST_F(NavigationTest, ADeviceThatPoliciesAreNotTrainedOnIsRefusedWhereverItIs) {
  for (const char* task : {"ppo", "imitation"}) {
    try {
      Job(Config(task, folder_->path() / "device", "device: cuda\n"));
      FAIL();
    } catch (const sim::FileError& e) {
      EXPECT_THAT(e.what(), HasSubstr("device is cuda, but this task is trained on processors"));
      EXPECT_THAT(e.what(), HasSubstr("policy.yaml:"));
    }
  }
}

TEST_F(NavigationTest, ImitationResumesBitForBit) {
  ExpectResumes("imitation",
                "lanes: 4\ngroup: 2\nrollout: 4\nepochs: 2\nminibatches: 2\n"
                "dagger: {from: 1, to: 4, least: 0.2, stop_from: 0.3}\n");
}

/// Killed in the rollouts of the value alone and after them.
TEST_F(NavigationTest, KilledProcessesOfPpoGoOnBitForBit) {
  ExpectResumes("ppo", "ppo: {lanes: 4, group: 2, rollout: 4, value_first: 3}\n", "_processes",
                KillProcess);
}

TEST_F(NavigationTest, APolicyThatImitatesMayStopAsItsAgentDoes) {
  agent::PolicyConfig config;
  config.rows = 32;
  config.width = 4;
  PictureNet net(config, std::nullopt, 1);
  const auto drawn = [&](double stop) {
    const double other = (1.0 - stop) / 3.0;
    std::array<float, 4> said{};
    said.fill(static_cast<float>(std::log(other)));
    said[static_cast<std::size_t>(sim::Action::kStop)] = static_cast<float>(std::log(stop));
    std::array<int, 4> counts{};
    sim::Rng rng(7, "draws");
    for (int i = 0; i < 300; ++i) ++counts.at(static_cast<std::size_t>(net.Draw(said, &rng)));
    return counts[static_cast<std::size_t>(sim::Action::kStop)];
  };
  EXPECT_NEAR(drawn(0.4), 120, 30);
  net.StopFrom(0.5);
  EXPECT_EQ(drawn(0.4), 0);
  EXPECT_EQ(drawn(0.6), 300);
}

TEST_F(NavigationTest, WeightsCountTheFramesOfThoseThatTheyWentOnFrom) {
  const std::filesystem::path first = folder_->path() / "first";
  const std::filesystem::path second = folder_->path() / "second";
  Watcher watcher(0);
  RunTraining(Job(Config("imitation", first, "lanes: 4\ngroup: 2\nrollout: 4\n")), &watcher);
  EXPECT_EQ(agent::FramesTrained(first / "weights.safetensors"), 5 * 16);
  RunTraining(
      Job(Config("ppo", second,
                 "ppo: {lanes: 4, group: 2, rollout: 4}\nagent: {stop_from: 0.9}\npolicy_start: " +
                     (first / "weights.safetensors").string() + "\n")),
      &watcher);
  EXPECT_EQ(agent::FramesTrained(second / "weights.safetensors"), 2 * 5 * 16);
  EXPECT_THAT(sim::ReadTextFile(second / "weights.md"),
              HasSubstr("80 frames in all, on top of 80"));
}

TEST_F(NavigationTest, PpoGoesOnWithTheReturnsThatItHasSeen) {
  const auto trained = [&](const char* name, const std::string& more) {
    const std::filesystem::path out = folder_->path() / name;
    Watcher watcher(0);
    RunTraining(Job(Config("ppo", out, "ppo: {lanes: 4, group: 2, rollout: 4}\n" + more)),
                &watcher);
    return out / "weights.safetensors";
  };
  const auto returns = [](const std::filesystem::path& weights) {
    return std::bit_cast<double>(
        std::uint64_t{std::stoull(agent::ReadTensorFile(weights).metadata.at("return.count"))});
  };
  const std::filesystem::path first = trained("returns", "");
  const std::filesystem::path second =
      trained("more_returns", "policy_start: " + first.string() + "\n");
  EXPECT_EQ(returns(first), 5 * 16);
  EXPECT_EQ(returns(second), 2 * 5 * 16);
}

TEST_F(NavigationTest, PpoWithAMapResumesBitForBit) {
  ExpectResumes("ppo",
                "map\nppo: {lanes: 4, group: 2, rollout: 8}\ndraw: direct\naveraged_from: 0.5\n",
                "_map");
}

class DistillationTest : public NavigationTest {
 protected:
  /// A policy with depth to learn from, and what else a training is told of it.
  static std::string Guide(const std::string& name) {
    agent::PolicyConfig config;
    config.rows = config.features = config.memory = 32;
    config.step_limit = 40;
    config.precision = agent::Precision::kFloat32;
    const torch::Tensor pictures =
        torch::randint(0, 255, {4, 16 * 32 * 32}, at::detail::createCPUGenerator(1), torch::kUInt8);
    agent::PolicyNet own(config, 3);
    const agent::QuantisedNet encoder =
        agent::Quantise(&own, {pictures, pictures, torch::zeros({4, agent::kPolicyNumbers})});
    config.own_encoder = false;
    agent::PolicyNet guide(config, 4);
    guide.SeeWith(std::make_shared<agent::IntegerSight>(encoder, config.rows));
    const std::filesystem::path file = folder_->path() / name;
    agent::SavePolicy(guide, {}, agent::StoredType::kFloat32, file);
    return "setting: rgb\npolicy_start: " + file.string() + "\n";
  }
};

TEST_F(DistillationTest, ResumesBitForBit) {
  ExpectResumes("distillation", Guide("guide") + "lanes: 4\ngroup: 2\nrollout: 2\n");
}

TEST_F(DistillationTest, TeachesTheEncoderAlone) {
  class Explained final : public Watcher {
   public:
    void Validated(int /*step*/, const Measures& measures, const std::string& /*text*/) override {
      shares.push_back(measures.at("explained"));
    }
    std::vector<double> shares;
  } watcher;
  const std::filesystem::path out = folder_->path() / "distilled";
  std::string config = Config("distillation", out,
                              Guide("known") +
                                  "lanes: 4\ngroup: 2\nrollout: 4\noptimiser: {learning_rate: "
                                  "0.003, schedule: constant, warmup_steps: 0}\n");
  const std::string few = "steps: 5\nvalidate_every: 2\n";
  config.replace(config.find(few), few.size(), "steps: 40\nvalidate_every: 20\n");
  RunTraining(Job(config), &watcher);
  const auto guide = agent::LoadPolicy(folder_->path() / "known");
  const auto student = agent::LoadPolicy(out / "weights.safetensors");
  const auto expected = guide->named_parameters();
  int kept = 0;
  for (const auto& item : student->named_parameters()) {
    if (item.key().starts_with("encoder.")) continue;
    const torch::Tensor apart = (item.value() - expected[item.key()]).abs().max();
    EXPECT_LE(apart.item<float>(), 0.01f * expected[item.key()].abs().max().item<float>());
    ++kept;
  }
  EXPECT_GT(kept, 10);
  EXPECT_GT(watcher.shares.back(), watcher.shares.front() + 0.05);
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
  EXPECT_THAT(complaint("imitation", "lanes: 8\ngroup: 4\nminibatches: 3\n"),
              HasSubstr("minibatches must divide"));
  EXPECT_THAT(complaint("imitation", "stop_distance: 1\n"),
              HasSubstr("stop_distance must be positive and less than"));
  EXPECT_THAT(complaint("imitation", "dagger: {from: 5, to: 1}\n"),
              HasSubstr("to must not be before from"));
  EXPECT_THAT(complaint("imitation", "dagger: {from: 1, to: 5, stop_from: 1}\n"),
              HasSubstr("stop_from must be in [0, 1)"));
  EXPECT_THAT(complaint("imitation", "forward_weight: 0\n"),
              HasSubstr("forward_weight must be positive"));
  const auto refusal = [](NavigationData data) {
    try {
      data.Validate();
    } catch (const sim::Error& error) {
      return std::string(error.what());
    }
    return std::string("none");
  };
  NavigationData data = Data();
  data.plain_share = 0.5;
  EXPECT_EQ(refusal(data), "none");
  data.episodes = 4;
  EXPECT_THAT(refusal(data), HasSubstr("cannot be had with 'episodes'"));
  data.episodes = 0;
  data.plain_share = 1.5;
  EXPECT_THAT(refusal(data), HasSubstr("between 0 and 1"));
  data.plain_share = 0.5;
  data.scenes = {"house.glb"};
  data.houses.reset();
  EXPECT_THAT(refusal(data), HasSubstr("name some"));
  EXPECT_THAT(complaint("ppo", "agent: {stop_steps: 2}\n"),
              HasSubstr("stop_steps needs stop_from"));
  EXPECT_THAT(complaint("distillation", "policy_start: nowhere.safetensors\n"),
              HasSubstr("setting: rgb"));
  EXPECT_THAT(complaint("distillation", "setting: rgb\n"), HasSubstr("policy_start is missing"));
  EXPECT_THAT(complaint("distillation", "setting: rgb\npolicy_start: nowhere.safetensors\n"),
              HasSubstr("nowhere"));
  EXPECT_THAT(complaint("ppo", "policy_start: nowhere.safetensors\n"), HasSubstr("nowhere"));
  const std::string weights = BULLETNAV_WEIGHTS;
  for (const char* task : {"ppo", "imitation"}) {
    EXPECT_THAT(complaint(task, "setting: rgb\npolicy_start: " + weights +
                                    "/resnet_gru_il_rgbd.safetensors\n"),
                HasSubstr("trained in the setting rgbd, and knows nothing else"));
    EXPECT_THAT(complaint(task, "policy_start: " + weights + "/nts_rgbd.safetensors\n"),
                HasSubstr("does not hold the weights of a policy"));
  }
  EXPECT_THAT(complaint("ppo", "ppo: {lanes: 8, group: 4, minibatches: 3}\n"),
              HasSubstr("minibatches must divide"));
}

}  // namespace
}  // namespace bulletnav::bench
