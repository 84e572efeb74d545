// SPDX-License-Identifier: MIT
#pragma once
#include <variant>

#include "agent/slam/verify/panorama_lens.h"
#include "benchmark/slam/io/trajectory.h"

namespace bulletnav::bench {

/// What a level camera makes of points: a pinhole's flat pictures, with depth along its axis, or
/// panoramas, with level distances for depth.
using CameraLens = std::variant<Intrinsics, agent::PanoramaLens>;

}  // namespace bulletnav::bench
