// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>

#include "benchmark/training/supervised/scene_samples.h"

namespace bulletnav::bench {

/// Keeps samples on the disk. Bytes of a little-endian machine: the text "BNLABELS", u32 version,
/// u32 number n of points, u64 key, u64 FNV-1a of the rest, then poses [n] of 4 f64 (x, y, z, yaw),
/// explorable [n] u16, reach [n, 12] u16, pairs [n, n] of 16 bytes as in PairLabel.
/// `key`: of all that the samples were made from. Written atomically; throws sim::FileError.
void WriteSamples(const std::filesystem::path& file, const SceneSamples& samples,
                  std::uint64_t key);

/// Throws sim::FileError, saying what is wrong, unless the file is whole and has this key.
SceneSamples ReadSamples(const std::filesystem::path& file, std::uint64_t key);

}  // namespace bulletnav::bench
