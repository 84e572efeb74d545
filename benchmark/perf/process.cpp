// SPDX-License-Identifier: MIT
#include "benchmark/perf/process.h"

#include <chrono>
#include <cstdio>
#include <fstream>
#include <memory>
#include <string>

#include <fmt/core.h>
#include <unistd.h>

#include "sim/base/error.h"
#include "sim/simulator.h"

namespace bulletnav::bench {
namespace {

double ResidentMb() {
  double total_pages = 0.0;
  double resident_pages = 0.0;
  std::ifstream("/proc/self/statm") >> total_pages >> resident_pages;
  return resident_pages * static_cast<double>(::sysconf(_SC_PAGESIZE)) / 1048576.0;
}

std::string Quoted(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

/// A free place on the largest island.
sim::BodyPose SomePlace(const sim::World& world) {
  world.RequireFloor();
  const sim::NavmeshQuery query(world.navmesh());
  sim::CapsuleBody body(world.physics(), {});
  sim::Rng rng(1, "first observation");
  while (true) {
    const auto pose = body.TryReset({query.RandomPoint(&rng, 0).cast<double>(), 0.0});
    if (pose) return *pose;
  }
}

}  // namespace

void RunFirstObservation(const std::filesystem::path& scene, const sim::ImportOptions& import) {
  sim::WorldOptions options;
  options.import = import;
  options.backend = sim::Backend::kEmbree;
  const auto world = sim::World::Load(scene, options);
  const sim::BodyPose place = SomePlace(*world);
  sim::Simulator first(world, {});
  first.Reset(place);
  const double memory = ResidentMb();
  // The time ends with this line: the reader stops its clock when it comes.
  fmt::print("{:.3f}\n", memory);
  std::fflush(stdout);
  sim::Simulator second(world, {});
  second.Reset(place);
  second.Step(sim::Action::kMoveForward);
  fmt::print("{:.3f}\n", ResidentMb() - memory);
}

FirstObservation MeasureFirstObservation(const std::filesystem::path& program,
                                         const std::filesystem::path& scene,
                                         const sim::ImportOptions& import) {
  std::string command = Quoted(program.string()) + " first-observation " + Quoted(scene.string()) +
                        fmt::format(" --scale {}", import.scale);
  if (import.up) command += *import.up == sim::UpAxis::kY ? " --up y" : " --up z";
  if (import.ground_plane) command += " --ground-plane";
  if (import.doors) command += " --doors " + Quoted(import.doors->ToYaml());
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(::popen(command.c_str(), "r"), ::pclose);
  FirstObservation result;
  if (!pipe || std::fscanf(pipe.get(), "%lf", &result.memory_mb) != 1) {
    throw sim::Error("cannot measure the start of " + program.string());
  }
  result.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  if (std::fscanf(pipe.get(), "%lf", &result.second_worker_mb) != 1) {
    throw sim::Error("cannot measure the memory of " + program.string());
  }
  return result;
}

}  // namespace bulletnav::bench
