// SPDX-License-Identifier: MIT
#include "python/core/batch_speed.h"

#include <chrono>

#include "sim/batch_simulator.h"

namespace bulletnav::python {
namespace {

using Clock = std::chrono::steady_clock;

/// A simulator with memory for what its bodies see.
struct Batch {
  Batch(const bench::VectorEnvironment& environment, const LanesConfig& config);
  void Step(const std::vector<sim::Action>& actions) {
    simulator->Step(actions, sensors, {{}, {}, arrays});
  }

  std::vector<std::vector<std::byte>> memory;
  std::vector<sim::BatchArray> arrays;
  std::vector<sim::Sensors> sensors;
  std::unique_ptr<sim::BatchSimulator> simulator;
};

Batch::Batch(const bench::VectorEnvironment& environment, const LanesConfig& config)
    : sensors(static_cast<std::size_t>(environment.lanes())) {
  const bench::Task task = config.task();
  std::vector<std::shared_ptr<const sim::World>> worlds;
  worlds.reserve(sensors.size());
  for (int lane = 0; lane < environment.lanes(); ++lane) {
    worlds.push_back(environment.truth(lane).world);
  }
  const sim::SimulatorSpec spec{task.body,  task.panorama, task.noise,       task.color,
                                task.depth, task.sensors,  task.sensor_noise};
  simulator = std::make_unique<sim::BatchSimulator>(std::move(worlds), spec, config.threads);
  for (int lane = 0; lane < environment.lanes(); ++lane) {
    simulator->Reset(lane, environment.truth(lane).pose);
  }
  const std::vector<sim::ArraySpec> specs = simulator->arrays();
  memory.reserve(specs.size());
  arrays.reserve(specs.size());
  for (const sim::ArraySpec& array : specs) {
    arrays.push_back({array.name, memory.emplace_back(sensors.size() * array.bytes())});
  }
}

}  // namespace

double BatchSeconds(Lanes* lanes, const std::vector<std::vector<std::int64_t>>& actions,
                    std::size_t warm_up) {
  return lanes->View([&](const bench::VectorEnvironment& environment) {
    Batch batch(environment, lanes->config());
    Clock::time_point start = Clock::now();
    for (std::size_t step = 0; step < actions.size(); ++step) {
      if (step == warm_up) start = Clock::now();
      batch.Step(ReadActions(actions[step]));
    }
    return std::chrono::duration<double>(Clock::now() - start).count();
  });
}

}  // namespace bulletnav::python
