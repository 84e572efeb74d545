// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "benchmark/training/supervised/data_config.h"
#include "sim/math/pose.h"
#include "sim/scene/mesh.h"

namespace bulletnav::tests {

/// Two rooms of 4 x 4 m side by side, x in [0, 4] and [4, 8], z in [-4, 0]; the wall between them,
/// 12 cm thick, has a doorway from z = -2.45 to -1.55.
sim::SceneMesh TwoRooms();

/// On the floor at (x, 0, z).
sim::BodyPose StandingAt(double x, double z, double yaw_deg = 0.0);

/// The depth that a config's camera sees from a pose.
std::vector<float> DepthFrom(const sim::SceneMesh& mesh, const bench::DataConfig& config,
                             const sim::BodyPose& pose);

}  // namespace bulletnav::tests
