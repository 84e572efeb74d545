// SPDX-License-Identifier: MIT
#pragma once
#include "benchmark/base/json_cursor.h"
#include "benchmark/episodes/episode.h"

namespace bulletnav::bench {

/// One episode in Habitat's form. What Habitat has no key for goes inside `info`, where its loader
/// allows anything: goal_rotation (x, y, z, w), and further_goals, a list of {position, rotation,
/// radius, geodesic_distance}. Throws sim::FileError for what is missing or makes no sense.
Episode EpisodeFromJson(const JsonCursor& json);
Json EpisodeToJson(const Episode& episode);

}  // namespace bulletnav::bench
