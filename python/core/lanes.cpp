// SPDX-License-Identifier: MIT
#include "python/core/lanes.h"

#include "python/core/arguments.h"

#include <numeric>
#include <utility>

#include <fmt/core.h>
#include <unistd.h>

#include "benchmark/episodes/episode_file.h"
#include "sim/base/error.h"
#include "sim/observation.h"
#include "sim/sensors/noise/sensor_noise.h"

namespace bulletnav::python {
namespace {

constexpr int kEasyPerScene = 20;
constexpr std::size_t kWorldsBesideLanes = 16;

sim::Error Misuse(const std::string& what) {
  return sim::Error("bulletnav environment: " + what);
}

bool HasArray(const sim::SensorSet& sensors, std::string_view name) {
  for (const sim::ArraySpec& array : sensors.arrays()) {
    if (array.name == name) return true;
  }
  return false;
}

}  // namespace

std::vector<sim::Action> ReadActions(const std::vector<std::int64_t>& numbers) {
  std::vector<sim::Action> actions;
  actions.reserve(numbers.size());
  for (const std::int64_t number : numbers) {
    if (number < 0 || number >= static_cast<std::int64_t>(sim::kAllActions.size())) {
      throw Misuse(fmt::format(
          "{} is no action; 0: stop, 1: move forward, 2: turn left, 3: turn right", number));
    }
    actions.push_back(static_cast<sim::Action>(number));
  }
  return actions;
}

void LanesConfig::Validate() const {
  if (scenes.empty() == episodes.empty()) {
    throw sim::Error(
        "name what to play: scenes=[FILE, ...] to draw episodes in (bulletnav.generate makes "
        "some), or episodes=FILE, and not both");
  }
  if (!episodes.empty() && counts) {
    throw sim::KeyError("counts", "counts are of episodes to be drawn; episodes=FILE has its own");
  }
  if (num_envs < 1 || num_envs > 65536) {
    throw sim::KeyError("num_envs", "num_envs must lie between 1 and 65536");
  }
  sim::RequireSensorNoise(sensor_noise);
  if (max_steps < 1) throw sim::KeyError("max_steps", "max_steps must be at least 1");
  if (!(success_distance >= 0.0)) {
    throw sim::KeyError("success_distance", "success_distance must not be negative");
  }
  if (!sensors.panorama()) {
    throw sim::KeyError("sensors",
                        "the goal is a panorama; name a sensor 'panorama' of that type, as in "
                        "{'panorama': {'type': 'panorama', 'channels': ['color']}}");
  }
}

bench::Task LanesConfig::task() const {
  bench::Task task;
  task.body = body;
  task.panorama = sensors.panorama().value();
  task.color = HasArray(sensors, sim::Observation::kColor);
  task.depth = HasArray(sensors, sim::Observation::kDepth);
  task.sensors = sensors;
  task.noise = noise;
  task.sensor_noise = sim::NamedSensorNoise(sensor_noise);
  task.success = {success_distance, no_stop};
  task.max_steps = max_steps;
  task.reward = reward;
  return task;
}

Lanes::Lanes(const std::string& config, bench::Warn warn)
    : config_(ReadArguments<LanesConfig>(config)), process_(::getpid()) {
  worlds_ = std::make_unique<WorldShelf>(
      config_.world_options(),
      std::vector<std::filesystem::path>(config_.scene_folders.begin(),
                                         config_.scene_folders.end()),
      static_cast<std::size_t>(config_.num_envs) + kWorldsBesideLanes, std::move(warn));
  bench::VectorSpec spec;
  spec.task = config_.task();
  spec.episodes = Episodes();
  spec.lanes = config_.num_envs;
  spec.threads = config_.threads;
  spec.seed = config_.seed;
  spec.shuffle = config_.shuffle;
  spec.autoreset = config_.autoreset_mode;
  const auto find = [this](const std::string& scene) {
    return worlds_->Get(scene);
  };
  // The threads of an environment are not there in a process that was forked off: it is left alone.
  const auto drop = [process = process_](bench::VectorEnvironment* environment) {
    if (::getpid() == process) delete environment;  // NOLINT: a deleter
  };
  environment_ = {new bench::VectorEnvironment(std::move(spec), find), drop};  // NOLINT: as above
}

Lanes::~Lanes() {
  if (::getpid() == process_) {
    Close();
    return;
  }
  // Nor is the thread that a future waits for, nor are those of renderers.
  new std::future<void>(std::move(under_way_));  // NOLINT: left alone
  worlds_.release();                             // NOLINT: likewise
}

std::vector<bench::Episode> Lanes::Episodes() {
  if (!config_.episodes.empty()) return bench::ReadEpisodes(config_.episodes).episodes;
  bench::GeneratorSpec draw;
  draw.import = config_.scene_import;
  draw.counts.easy = kEasyPerScene * static_cast<int>(config_.scenes.size());
  draw.counts = config_.counts.value_or(draw.counts);
  draw.sequential_goals = config_.sequential_goals;
  draw.seed = config_.episode_seed;
  draw.body = config_.body;
  draw.navmesh = config_.navmesh;
  return bench::GenerateEpisodes(draw, config_.scenes, config_.threads, {}, worlds_->cache());
}

std::unique_lock<std::mutex> Lanes::Use(bool is_receiving) {
  if (::getpid() != process_) {
    throw Misuse("it belongs to the process that made it; make one in each process, after forking");
  }
  std::unique_lock lock(mutex_, std::try_to_lock);
  if (!lock.owns_lock()) throw Misuse("another thread is using it; one at a time");
  if (is_closed_) throw Misuse("it is closed");
  if (is_receiving && !under_way_.valid()) throw Misuse("nothing was sent; call send first");
  if (!is_receiving && under_way_.valid()) throw Misuse("a step is under way; call recv first");
  return lock;
}

void Lanes::Reset(std::optional<std::uint64_t> seed) {
  const auto use = Use();
  if (seed || !is_begun_) {
    environment_->Reset(seed.value_or(config_.seed));
    is_begun_ = true;
    return;
  }
  std::vector<int> all(static_cast<std::size_t>(config_.num_envs));
  std::iota(all.begin(), all.end(), 0);
  environment_->ResetLanes(all);
}

void Lanes::ResetLanes(std::vector<int> lanes) {
  const auto use = Use();
  environment_->ResetLanes(lanes);
}

Lanes::Order Lanes::Read(const std::vector<std::int64_t>& actions,
                         const std::optional<std::vector<int>>& lanes) const {
  Order order;
  if (!is_begun_) throw Misuse("call reset first");
  if (lanes) {
    order.lanes = *lanes;
  } else {
    order.lanes.resize(static_cast<std::size_t>(config_.num_envs));
    std::iota(order.lanes.begin(), order.lanes.end(), 0);
  }
  if (actions.size() != order.lanes.size()) {
    throw Misuse(fmt::format("got {} actions for {} lanes", actions.size(), order.lanes.size()));
  }
  order.actions = ReadActions(actions);
  return order;
}

void Lanes::Step(const std::vector<std::int64_t>& actions,
                 const std::optional<std::vector<int>>& lanes) {
  const auto use = Use();
  const Order order = Read(actions, lanes);
  environment_->Step(order.lanes, order.actions);
}

void Lanes::Send(const std::vector<std::int64_t>& actions,
                 const std::optional<std::vector<int>>& lanes) {
  const auto use = Use();
  Order order = Read(actions, lanes);
  sent_ = order.lanes;
  under_way_ = std::async(std::launch::async, [this, order = std::move(order)] {
    environment_->Step(order.lanes, order.actions);
  });
}

std::vector<int> Lanes::Receive() {
  const auto use = Use(/*is_receiving=*/true);
  under_way_.get();
  return sent_;
}

void Lanes::Close() {
  if (::getpid() != process_) return;
  const std::lock_guard lock(mutex_);
  if (under_way_.valid()) under_way_.wait();
  is_closed_ = true;
  environment_.reset();
}

}  // namespace bulletnav::python
