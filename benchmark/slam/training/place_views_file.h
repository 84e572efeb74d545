// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

#include "benchmark/slam/training/place_views.h"

namespace bulletnav::bench {

/// Keeps views on the disk. Bytes of a little-endian machine: the text "BNPLACES", u32 version,
/// u32 places, views, rows, cols, u64 key, u64 FNV-1a of the rest, then poses [count] of 4 f64
/// (x, y, z, yaw), shared, pictures. `key`: of all that they were made from. Written atomically;
/// throws sim::FileError.
void WritePlaceViews(const std::filesystem::path& file, const PlaceViews& views, std::uint64_t key);

/// Throws sim::FileError, saying what is wrong, unless the file is whole and has this key.
PlaceViews ReadPlaceViews(const std::filesystem::path& file, std::uint64_t key);

/// The views of a scene: from below config.cache if they are there and whole, else they are made
/// and kept. Throws sim::Error for a scene that they cannot be had of, with its name.
PlaceViews PlaceViewsOf(const std::filesystem::path& scene, const PlaceDataConfig& config);

/// Of all scenes, one a worker, one per processor; the same for any number. `on_scene` is called,
/// from any thread, as they are done.
std::vector<PlaceViews> AllPlaceViews(const PlaceDataConfig& config,
                                      const std::function<void()>& on_scene);

}  // namespace bulletnav::bench
