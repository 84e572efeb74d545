// SPDX-License-Identifier: MIT
// A program outside this project, as in docs/extending.md: ten random steps from a free place.
#include <cstdio>
#include <exception>

#include "sim/simulator.h"

namespace {

using namespace bulletnav::sim;

void Walk(const char* file) {
  const auto world = World::Load(file);
  world->RequireFloor();
  Rng rng(1, "walk");
  const Eigen::Vector3f place = NavmeshQuery(world->navmesh()).RandomPoint(&rng, 0);
  Simulator simulator(world, {});
  Observation observation = simulator.Reset({.position = place.cast<double>(), .yaw = 0.0});
  for (int step = 0; step < 10; ++step) {
    observation = simulator.Step(rng.Chance(0.7) ? Action::kMoveForward : Action::kTurnLeft);
    const auto [x, y, yaw] = observation.sensors.odometry;
    std::printf("moved %.3f %.3f m, turned %.1f deg, %s, looks at what is %.2f m away\n", x, y,
                RadToDeg(yaw), observation.sensors.collided ? "touched something" : "free",
                observation.depth[64 * 512 + 256]);
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: walk SCENE\n");
    return 2;
  }
  try {
    Walk(argv[1]);
    return 0;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "walk: %s\n", e.what());
    return 1;
  }
}
