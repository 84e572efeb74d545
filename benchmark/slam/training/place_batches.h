// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "benchmark/slam/training/place_views.h"

namespace bulletnav::bench {

/// Views that are learned from together.
struct PlaceBatch {
  int count = 0;
  std::vector<std::uint8_t> pictures;  // [count, rows, cols, 3]
  std::vector<float> covisibility;     // [count, count]; 0 between scenes
};

struct PlaceBatchSpec {
  int places = 16;
  int scenes = 2;
  int rows = kViewRows;  // of pictures: kViewRows or half of it
  std::uint64_t seed = 0;
  std::optional<PictureAugmentSpec> augment;  // absent: pictures as they were drawn
};

/// All views of some places of some scenes.
class PlaceBatches {
 public:
  /// Throws sim::Error if there are fewer scenes, or a scene has fewer places, than a batch takes.
  PlaceBatches(std::vector<PlaceViews> scenes, const PlaceBatchSpec& spec);

  const std::vector<PlaceViews>& scenes() const { return scenes_; }
  int views() const { return scenes_.front().views; }
  /// A function of scenes, spec and number. May be called from several threads.
  PlaceBatch Batch(std::uint64_t number) const;

 private:
  std::vector<PlaceViews> scenes_;
  PlaceBatchSpec spec_;
};

/// A picture as it is, or means over squares of two pixels, to the nearest.
std::vector<std::uint8_t> PictureOf(const PlaceViews& views, int number, int rows);

}  // namespace bulletnav::bench
