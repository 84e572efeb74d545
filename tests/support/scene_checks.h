// SPDX-License-Identifier: MIT
#pragma once
#include <memory>

#include "sim/physics/capsule_body.h"
#include "sim/world.h"

namespace bulletnav::tests {

/// 10,000 random noisy steps, a new start every 500: never outside, never inside a wall, never NaN,
/// always over a floor, and never stuck for good.
void CheckWalk(const std::shared_ptr<const sim::World>& world, const sim::BodySpec& spec);

/// EGL's panoramas against Embree's from free places, SPEC section 9: depth within 1 cm or 1% on
/// 99.5% of pixels away from depth edges, colour within 8 / 255 on 99%.
void CheckBackendsAgree(const sim::SceneMesh& mesh, const sim::World& world, int places);

/// Depths of panoramas from free places against Bullet's rayTest.
void CheckDepthAgainstPhysics(const sim::World& world, int places);

}  // namespace bulletnav::tests
