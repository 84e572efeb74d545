// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "benchmark/play/trajectory.h"
#include "sim/image/image.h"
#include "sim/render/projection.h"
#include "sim/world.h"

namespace bulletnav::bench {

/// The panorama seen by a body at a pose, RGB.
sim::Image LookFrom(const sim::World& world, const sim::BodySpec& body,
                    const sim::PanoramaSpec& panorama, const sim::BodyPose& pose);

/// Lives through an episode again, action for action with the same noise, and returns what the body
/// saw after the numbers of steps named, which must rise (checked); 0 is the start. The pictures
/// may be larger or smaller than those that the agent had. Throws sim::Error if the body
/// comes off the recorded path by more than a centimetre: the scene or the program is another.
std::vector<sim::Image> ReplayPanoramas(const std::shared_ptr<const sim::World>& world,
                                        const EpisodeTrajectory& trajectory,
                                        const sim::PanoramaSpec& panorama,
                                        std::span<const int> steps);

}  // namespace bulletnav::bench
