// SPDX-License-Identifier: MIT
#include "benchmark/perf/train_figures.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "benchmark/training/core/adam.h"
#include "benchmark/training/rl/navigation/navigation_plan.h"
#include "benchmark/training/rl/ppo.h"

namespace bulletnav::bench {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kRounds = 3;
constexpr int kSteps = 16;  // of each lane in a round
constexpr std::uint64_t kSeed = 1;

double SecondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// The same pictures in each step, for free.
class StillTask final : public PolicyTask {
 public:
  StillTask(int lanes, std::size_t bytes) : lanes_(lanes), bytes_(bytes) {}
  int lanes() const override { return lanes_; }
  int actions() const override { return 4; }
  int observation_size() const override { return agent::kPolicyNumbers; }
  std::size_t picture_bytes() const override { return bytes_; }
  void Begin(int /*lane*/, std::uint64_t /*episode*/) override {}
  void Observe(std::span<float> numbers, std::span<std::uint8_t> pictures) override {
    std::fill(numbers.begin(), numbers.end(), 0.0F);
    std::fill(pictures.begin(), pictures.end(), std::uint8_t{100});
  }
  void Step(std::span<const int> /*actions*/, std::span<LaneOutcome> outcomes) override {
    std::fill(outcomes.begin(), outcomes.end(), LaneOutcome{});
  }
  std::vector<float> State() const override { return {}; }
  void SetState(std::span<const float> /*state*/) override {}

 private:
  int lanes_;
  std::size_t bytes_;
};

/// One way to train.
class TrainBench {
 public:
  TrainBench(const NavigationPlan& plan, NavigationScenes* scenes)
      : lanes_(plan.Lanes({spec_.lanes, 0}), scenes, &pool_),
        net_(plan.MakeNet(kSeed)),
        groups_(
            spec_.lanes, spec_.group,
            [plan] {
              return plan.MakeNet(kSeed);
            },
            net_.get(), &pool_),
        optimiser_(*net_, OptimiserSpec{}) {}

  int workers() const { return pool_.workers(); }
  double frames() const { return double{kSteps} * spec_.lanes; }

  double SimulatorSeconds() {
    for (int lane = 0; lane < lanes_.lanes(); ++lane) lanes_.Begin(lane, 0);
    const auto count = static_cast<std::size_t>(lanes_.lanes());
    std::vector<float> numbers(count * agent::kPolicyNumbers);
    std::vector<std::uint8_t> pictures(count * lanes_.picture_bytes());
    std::vector<int> actions(count);
    std::vector<LaneOutcome> outcomes(count);
    const Clock::time_point start = Clock::now();
    for (int step = 0; step < kSteps; ++step) {
      lanes_.Observe(numbers, pictures);
      for (std::size_t i = 0; i < count; ++i) {
        actions[i] = 1 + static_cast<int>(i + static_cast<std::size_t>(step)) / 3 % 3;
      }
      lanes_.Step(actions, outcomes);
    }
    return SecondsSince(start);
  }

  double InferenceSeconds() {
    StillTask still(spec_.lanes, lanes_.picture_bytes());
    Actor actor(&still, net_.get(), &pool_, spec_.group, kSeed);
    const Clock::time_point start = Clock::now();
    actor.Play(Play(), {});
    return SecondsSince(start);
  }

  struct Whole {
    double play = 0.0;
    double update = 0.0;
  };
  Whole WholeSeconds() {
    Actor actor(&lanes_, net_.get(), &pool_, spec_.group, kSeed);
    Whole whole;
    Clock::time_point start = Clock::now();
    const Rollout rollout = actor.Play(Play(), {});
    whole.play = SecondsSince(start);
    start = Clock::now();
    RunningMoments moments;
    LearnFrom(rollout, spec_, {&optimiser_, 1e-4, kSeed}, &groups_, net_.get(), &moments);
    whole.update = SecondsSince(start);
    return whole;
  }

 private:
  static PlaySpec Play() {
    PlaySpec play;
    play.steps = kSteps;
    return play;
  }

  PpoSpec spec_;
  sim::WorkerPool pool_{0};
  NavigationLanes lanes_;
  std::unique_ptr<PictureNet> net_;
  LaneGroups groups_;
  Adam optimiser_;
};

NavigationPlan PlanOf(DrawMode draw, bool map) {
  NavigationPlan plan;
  plan.setting = LaneSetting::kRgbd;
  plan.draw = draw;
  plan.model.fusion = agent::Fusion::kLate;
  plan.model.map = map;
  return plan;
}

double MedianSeconds(const std::function<double()>& measure) {
  std::vector<double> seconds;
  for (int round = 0; round < kRounds; ++round) seconds.push_back(measure());
  return Median(seconds);
}

}  // namespace

void MeasureTraining(const BenchScene& scene, const std::function<void(const BenchFigure&)>& tell) {
  NavigationData data;
  data.scenes = {scene.file.string()};
  data.import.scale = scene.import.scale;
  data.import.up = scene.import.up;
  data.import.ground_plane = scene.import.ground_plane;
  NavigationScenes scenes(data, sim::BodySpec{}, 0);
  struct Way {
    const char* name;
    DrawMode draw;
    bool map;
  };
  for (const Way& way :
       {Way{"", DrawMode::kAveraged, false}, Way{"_direct", DrawMode::kDirect, false},
        Way{"_direct_map", DrawMode::kDirect, true}}) {
    TrainBench bench(PlanOf(way.draw, way.map), &scenes);
    const auto tell_frames = [&](const std::string& what, double seconds) {
      tell({"train_frames" + what + way.name, bench.frames() / seconds, "frames/s",
            scene.file.filename().string(), "embree", bench.workers()});
    };
    tell_frames("_simulator", MedianSeconds([&] {
                  return bench.SimulatorSeconds();
                }));
    const bool is_other_net = way.draw == DrawMode::kAveraged || way.map;
    if (is_other_net) {
      tell_frames("_inference", MedianSeconds([&] {
                    return bench.InferenceSeconds();
                  }));
    }
    std::vector<double> update;
    const double whole = MedianSeconds([&] {
      const TrainBench::Whole seconds = bench.WholeSeconds();
      update.push_back(seconds.update);
      return seconds.play + seconds.update;
    });
    if (is_other_net) tell_frames("_update", Median(update));
    tell_frames("", whole);
  }
}

}  // namespace bulletnav::bench
