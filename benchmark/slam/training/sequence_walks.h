// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <vector>

#include "agent/slam/descriptors/picture_describer.h"
#include "agent/slam/topology/sequences.h"
#include "benchmark/slam/training/place_config.h"
#include "sim/world.h"

namespace bulletnav::bench {

/// A walk through a scene as a network sees it, of which descriptors of sequences are learned.
struct SequenceWalk {
  int frames = 0;
  std::size_t frame_bytes = 0;      // [cells, channels]
  std::vector<std::uint8_t> cells;  // [frames, frame_bytes]; see PictureDescriber::Cells
  std::vector<agent::PictureDescriptor> descriptors;  // [frames]
  std::vector<agent::Sequence> sequences;             // of one cluster each
  std::vector<std::uint8_t> is_covisible;             // [frames, frames] 0 or 1: kSamePlace or more

  std::span<const std::uint8_t> Frames(int first, int count) const {
    return std::span(cells).subspan(static_cast<std::size_t>(first) * frame_bytes,
                                    static_cast<std::size_t>(count) * frame_bytes);
  }
};

/// Consecutive frames of a walk.
struct Window {
  int first = 0;
  int count = 0;
};

/// The share of frames of `a` that a frame of `b` is covisible with.
double ShareCovisible(const SequenceWalk& walk, const Window& a, const Window& b);

struct WalkSpec {
  int frames = 700;
  std::uint64_t seed = 0;
};

/// Walks along shortest paths between places at random, 25 cm or 10 degrees from frame to frame,
/// with the data's body and camera, and cuts the walk into sequences as HierarchyDetector does. A
/// function of the arguments. Throws sim::Error if there is no floor.
SequenceWalk MakeSequenceWalk(const sim::World& world, const PlaceDataConfig& data,
                              const WalkSpec& spec, agent::PictureDescriber* describer);

/// `runs` walks through each of the first `scenes` scenes (0: all), one scene a worker; the same
/// for any number. `descriptor`: file of weights of a PictureDescriber.
std::vector<SequenceWalk> MakeSequenceWalks(const PlaceDataConfig& data, int scenes, int runs,
                                            int frames, const std::filesystem::path& descriptor,
                                            const std::function<void()>& on_scene);

}  // namespace bulletnav::bench
