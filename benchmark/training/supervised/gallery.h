// SPDX-License-Identifier: MIT
#pragma once
#include <functional>

#include "benchmark/training/supervised/data_config.h"
#include "sim/image/image.h"

namespace bulletnav::bench {

/// One sheet of what a training on a config sees: a panorama from each of `count` of its scenes,
/// taken evenly from their list, each in its look; in two columns, the list from above. The place
/// in a scene is the first that is labelled. `on_scene` is called as scenes are done. Throws
/// sim::Error for a scene that cannot be read or has no floor.
sim::Image DrawGallery(const DataConfig& config, int count, const std::function<void()>& on_scene);

}  // namespace bulletnav::bench
