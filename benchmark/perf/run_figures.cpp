// SPDX-License-Identifier: MIT
#include "benchmark/perf/run_figures.h"

#include <chrono>
#include <memory>
#include <string>
#include <utility>

#include <fmt/core.h>

#include "agent/integer/kernels/kernels.h"
#include "benchmark/play/environment.h"
#include "benchmark/runs/runner.h"
#include "sim/base/temporary_folder.h"

namespace bulletnav::bench {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kRounds = 3;  // of each way to play the episodes, in turn

double SecondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// The files' places are put in afterwards: they may hold anything.
const std::string kConfig =
    "name: bench\n"
    "backend: embree\n"
    "episodes:\n"
    "  file: episodes.json.gz\n"
    "  draw: {scenes: [scene], counts: {easy: 8, medium: 8, hard: 8}, seed: 0}\n"
    "agents: [";

/// What playing the episodes without the runner took.
struct PlainTimes {
  double all_s = 0.0;
  double agent_s = 0.0;
  long steps = 0;
};

class RunBench {
 public:
  RunBench(const BenchScene& scene, const std::string& agent)
      : config_(ParseRunConfig(kConfig + agent + "]\n", "bench.yaml")) {
    config_.episodes.file = (folder_.path() / "episodes.json.gz").string();
    config_.episodes.draw->scenes = {scene.file.string()};
    config_.import.scale = scene.import.scale;
    config_.import.up = scene.import.up;
    config_.import.ground_plane = scene.import.ground_plane;
    config_.import.doors = scene.import.doors;
    agents_ = FindAgents(config_);
    RequireAll(agents_);
    RunConfig copy = config_;
    SceneCache scenes(config_.world_options());
    const StartProgress quiet = [](const std::string&, int) {
      return [] {};
    };
    episodes_ = PrepareEpisodes(&copy, {}, {scenes, 1, quiet});
    world_ = sim::World::Load(scene.file, config_.world_options());
  }

  PlainTimes Plain() {
    PlainTimes times;
    const Clock::time_point start = Clock::now();
    const GroundTruth* truth = &truth_;
    const auto agent = Build(agents_.front(), config_, "rgbd", {&truth, 1});
    Environment environment(TaskOf(config_, "rgbd", Condition::kNoise, /*sees=*/true), {&truth_},
                            1);
    for (const Episode& episode : episodes_.episodes) {
      PlayPlain(episode, &environment, agent.get(), &times);
    }
    times.all_s = SecondsSince(start);
    return times;
  }

  /// Seconds until the last episode is on the disk, the world's making included.
  double WithRunner(int workers) {
    const sim::TemporaryFolder results;
    Clock::time_point start;
    double seconds = 0.0;
    RunHooks hooks;
    hooks.begin = [&](std::size_t, std::span<const EpisodeResult>) {
      start = Clock::now();
    };
    hooks.finish = [&](const EpisodeResult&) {
      seconds = SecondsSince(start);
    };
    RunBenchmark(config_, results.path(), {{}, workers, true}, hooks);
    return seconds;
  }

  /// Of making a world of what has been imported to check the episodes.
  double LoadSeconds() const {
    const std::filesystem::path& file = episodes_.scene_files.begin()->second;
    const sim::ImportedScene scene = sim::ImportScene(file, config_.import.options());
    const Clock::time_point start = Clock::now();
    const sim::World world(file.filename().string(), scene, config_.world_options());
    return SecondsSince(start);
  }

 private:
  void PlayPlain(const Episode& episode, Environment* environment, agent::BatchAgent* agent,
                 PlainTimes* times) {
    const int lane = 0;
    EpisodeTask task;
    task.episode = episode;
    task.scene_file = episodes_.scene_files.at(episode.scene);
    environment->Reset(lane, std::move(task), world_);
    while (!environment->is_over(lane)) {
      if (environment->TakeNewGoal(lane)) {
        agent->Reset(lane, environment->goal(lane), environment->agent_seed(lane));
      }
      environment->Observe({&lane, 1});
      const agent::LaneObservation seen = {lane, environment->observation(lane)};
      sim::Action action = sim::Action::kStop;
      const Clock::time_point start = Clock::now();
      agent->Act({&seen, 1}, {&action, 1});
      times->agent_s += SecondsSince(start);
      environment->Step({&lane, 1}, {&action, 1});
      ++times->steps;
    }
  }

  sim::TemporaryFolder folder_;
  RunConfig config_;
  std::vector<RunAgent> agents_;
  RunEpisodes episodes_;
  std::shared_ptr<const sim::World> world_;
  GroundTruth truth_;
};

}  // namespace

void MeasureRuns(const BenchScene& scene, const std::function<void(const BenchFigure&)>& tell) {
  RunBench bench(scene, "{agent: metric_map_fbe, models: {semantic_model: oracle}}");
  std::vector<double> plain;
  std::vector<double> one;
  std::vector<double> two;
  std::vector<double> agent_ms;
  double steps = 0.0;
  for (int round = 0; round < kRounds; ++round) {
    const PlainTimes times = bench.Plain();
    steps = static_cast<double>(times.steps);
    plain.push_back(times.all_s);
    agent_ms.push_back(1e3 * times.agent_s / steps);
    const double load = bench.LoadSeconds();
    one.push_back(bench.WithRunner(1) - load);
    two.push_back(bench.WithRunner(2) - load);
  }
  const std::string name = scene.file.filename().string();
  const double alone = Median(one);
  tell({"fbe_run_steps", steps / alone, "steps/s", name, "embree", 1});
  tell({"fbe_mapping_and_planning", Median(agent_ms), "ms/step", name, "", 1});
  tell({"runner_overhead", 100.0 * (alone - Median(plain)) / alone, "%", name, "embree", 1});
  tell({"fbe_run_steps_two_workers", steps / Median(two), "steps/s", name, "embree", 2});
  tell({"run_two_workers_over_one", alone / Median(two), "ratio", name, "embree", 2});
}

void MeasureLearnedRuns(const BenchScene& scene,
                        const std::function<void(const BenchFigure&)>& tell) {
  RunBench bench(scene, "{agent: nts}");
  const double steps = static_cast<double>(bench.Plain().steps);
  std::vector<double> seconds;
  for (int round = 0; round < kRounds; ++round) {
    const double load = bench.LoadSeconds();
    seconds.push_back(bench.WithRunner(1) - load);
  }
  tell({"nts_run_steps", steps / Median(seconds), "steps/s", scene.file.filename().string(),
        "embree", 1, agent::SupportedIntegerKernels().front()->name});
}

}  // namespace bulletnav::bench
