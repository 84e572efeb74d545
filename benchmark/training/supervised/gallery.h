// SPDX-License-Identifier: MIT
#pragma once
#include <functional>

#include "benchmark/training/supervised/data_config.h"
#include "sim/image/image.h"

namespace bulletnav::bench {

/// One sheet of what a training on a config sees: `count` panoramas, one below the other, of scenes
/// taken evenly from the config's list, each in its look. Places are the first that are labelled:
/// one a scene, or more where there are fewer scenes than panoramas. `on_panorama` is called after
/// each. Expects: 1 or more (checked). Throws sim::Error for a scene that cannot be read or has no
/// floor.
sim::Image DrawGallery(const DataConfig& config, int count,
                       const std::function<void()>& on_panorama);

}  // namespace bulletnav::bench
