// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "benchmark/slam/training/sequence_walks.h"
#include "sim/math/rng.h"

namespace bulletnav::tests {

inline constexpr int kWalkChannels = 16;  // of cells, and numbers of descriptors
inline constexpr int kWalkCells = 4;
inline constexpr int kRoom = 15;  // frames

/// Rooms in turn, twice round; frames of one room see the same, a little off.
inline bench::SequenceWalk RandomWalk(std::uint64_t seed) {
  constexpr int kRooms = 6;
  bench::SequenceWalk walk;
  walk.frames = 2 * kRooms * kRoom;
  walk.frame_bytes = kWalkCells * kWalkChannels;
  sim::Rng noise(seed, "noise");
  for (int frame = 0; frame < walk.frames; ++frame) {
    sim::Rng room(seed + static_cast<std::uint64_t>(frame / kRoom % kRooms), "room");
    for (std::size_t i = 0; i < walk.frame_bytes; ++i) {
      walk.cells.push_back(static_cast<std::uint8_t>(room.Between(0, 200) + noise.Between(0, 50)));
    }
    std::vector<std::int64_t> numbers;
    for (int i = 0; i < kWalkChannels; ++i) {
      numbers.push_back(room.Between(-100, 100) + noise.Between(-30, 30));
    }
    walk.descriptors.push_back(agent::DirectionOf(numbers));
  }
  for (int first = 0; first < walk.frames; first += kRoom) {
    walk.sequences.push_back({first, first + kRoom - 1, first / kRoom % kRooms});
  }
  for (int a = 0; a < walk.frames; ++a) {
    for (int b = 0; b < walk.frames; ++b) {
      walk.is_covisible.push_back(a / kRoom % kRooms == b / kRoom % kRooms ? 1 : 0);
    }
  }
  return walk;
}

}  // namespace bulletnav::tests
